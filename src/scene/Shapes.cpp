#include "scene/Shapes.h"

#include <cmath>
#include <numbers>

namespace limpid {

namespace {

void addVertex(Mesh& mesh, const glm::dvec3& position, const glm::vec3& normal, const glm::vec2& uv) {
    mesh.positions.push_back(position);
    mesh.normals.push_back(normal);
    mesh.uvs.push_back(uv);
}

/// A rectangle around `center`; `u` and `v` are its half edges, `cross(u, v)` points outward.
void addQuad(Mesh& mesh, const glm::dvec3& center, const glm::dvec3& u, const glm::dvec3& v) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const glm::vec3 normal(glm::normalize(glm::cross(glm::normalize(u), glm::normalize(v))));
    addVertex(mesh, center - u - v, normal, {0, 1});
    addVertex(mesh, center + u - v, normal, {1, 1});
    addVertex(mesh, center + u + v, normal, {1, 0});
    addVertex(mesh, center - u + v, normal, {0, 0});
    for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u})
        mesh.indices.push_back(first + corner);
}

Mesh finished(Mesh mesh, const glm::vec3& albedo) {
    mesh.parts = {MeshPart{0, static_cast<std::uint32_t>(mesh.indices.size()), 0}};
    mesh.materials = {Material{glm::vec4(albedo, 1.0f), -1}};
    return mesh;
}

void addSphereVertices(Mesh& mesh, double radius, std::uint32_t segments) {
    using std::numbers::pi;
    for (std::uint32_t stack = 0; stack <= segments; ++stack) {
        const double polar = pi * stack / segments;
        // sin(π) is not 0 in floating point, and a pole has to be one point.
        const double ring = stack % segments == 0 ? 0.0 : std::sin(polar);
        for (std::uint32_t slice = 0; slice <= segments; ++slice) {
            // The seam closes exactly only if both of its ends use the same angle.
            const double azimuth = 2 * pi * (slice % segments) / segments;
            const glm::dvec3 normal(ring * std::cos(azimuth), std::cos(polar), -ring * std::sin(azimuth));
            addVertex(mesh, radius * normal, glm::vec3(normal),
                      {static_cast<float>(slice) / segments, static_cast<float>(stack) / segments});
        }
    }
}

} // namespace

Mesh makePlane(glm::dvec2 size, glm::vec3 albedo) {
    Mesh mesh;
    addQuad(mesh, glm::dvec3(0), {size.x / 2, 0, 0}, {0, 0, -size.y / 2});
    return finished(std::move(mesh), albedo);
}

Mesh makeSphere(double radius, glm::vec3 albedo, int segmentCount) {
    Mesh mesh;
    const auto segments = static_cast<std::uint32_t>(segmentCount);
    addSphereVertices(mesh, radius, segments);
    for (std::uint32_t stack = 0; stack < segments; ++stack)
        for (std::uint32_t slice = 0; slice < segments; ++slice) {
            const std::uint32_t top = stack * (segments + 1) + slice;
            const std::uint32_t bottom = top + segments + 1;
            if (stack > 0) mesh.indices.insert(mesh.indices.end(), {top, bottom, top + 1});
            if (stack + 1 < segments) mesh.indices.insert(mesh.indices.end(), {top + 1, bottom, bottom + 1});
        }
    return finished(std::move(mesh), albedo);
}

Mesh makeBox(glm::dvec3 size, glm::vec3 albedo) {
    Mesh mesh;
    const glm::dvec3 x(size.x / 2, 0, 0), y(0, size.y / 2, 0), z(0, 0, size.z / 2);
    addQuad(mesh, x, -z, y);
    addQuad(mesh, -x, z, y);
    addQuad(mesh, y, x, -z);
    addQuad(mesh, -y, x, z);
    addQuad(mesh, z, x, y);
    addQuad(mesh, -z, -x, y);
    return finished(std::move(mesh), albedo);
}

} // namespace limpid
