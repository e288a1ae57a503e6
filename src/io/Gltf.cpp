#include "io/Gltf.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>

#include <fmt/format.h>

#include "io/GltfAccessor.h"
#include "io/GltfFile.h"
#include "io/GltfMaterials.h"
#include "io/GltfNodes.h"
#include "io/GltfTriangles.h"

namespace limpid::io {

namespace {

/// Of the whole mesh: a small file can show one mesh at many nodes. 45 million triangles, some 6 GiB at most.
constexpr std::size_t maxCorners = std::size_t(1) << 27;

/// m; far beyond any scene, and squares of such lengths stay finite in single precision.
constexpr double maxCoordinate = 1e9;

using Attributes = std::map<std::string, int>;

/// What is common to the steps of adding one primitive at one node.
struct PrimitiveTask {
    const GltfFile& file;
    std::string place;
    const tinygltf::Primitive& primitive;
    const glm::dmat4& transform;
    Mesh& mesh;
    std::size_t firstVertex;               ///< in `mesh`
    std::vector<std::uint32_t> vertices{}; ///< of the primitive, in the order of their copies in `mesh`
};

AccessorKind positionKind() {
    return {TINYGLTF_TYPE_VEC3,
            {TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_COMPONENT_TYPE_BYTE,
             TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, TINYGLTF_COMPONENT_TYPE_SHORT,
             TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT},
            "vectors of 3 floats, or of 3 integers of 8 or 16 bits"};
}

AccessorKind normalKind() {
    return {TINYGLTF_TYPE_VEC3,
            {TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_COMPONENT_TYPE_BYTE, TINYGLTF_COMPONENT_TYPE_SHORT},
            "vectors of 3 floats, or of 3 integers of 8 or 16 bits with sign"};
}

AccessorKind uvKind() {
    AccessorKind kind = positionKind();
    kind.type = TINYGLTF_TYPE_VEC2;
    kind.text = "vectors of 2 floats, or of 2 integers of 8 or 16 bits";
    return kind;
}

std::optional<AccessorView> attribute(const PrimitiveTask& task, const std::string& name,
                                      const AccessorKind& kind) {
    const Attributes& attributes = task.primitive.attributes;
    const auto found = attributes.find(name);
    if (found == attributes.end()) return std::nullopt;
    return AccessorView(task.file, fmt::format("{}.attributes.{}", task.place, name), found->second, kind);
}

/// A further attribute, which must reach as far as the positions do.
std::optional<AccessorView> attribute(const PrimitiveTask& task, const std::string& name,
                                      const AccessorKind& kind, std::size_t count) {
    std::optional<AccessorView> view = attribute(task, name, kind);
    if (view && view->count() < count)
        task.file.fail(fmt::format("{}.attributes.{}", task.place, name),
                       fmt::format("{} elements, as POSITION has", count), fmt::format("{}", view->count()));
    return view;
}

glm::dvec3 readVec3(const AccessorView& view, std::size_t i) {
    return {view.component(i, 0), view.component(i, 1), view.component(i, 2)};
}

/// Gives every vertex that a corner uses a copy in the mesh: one for all corners, or one for each (flat).
void addIndices(PrimitiveTask& task, const std::vector<std::uint32_t>& corners, bool flat) {
    const auto first = static_cast<std::uint32_t>(task.firstVertex);
    std::unordered_map<std::uint32_t, std::uint32_t> copies;
    for (const std::uint32_t corner : corners) {
        const auto next = static_cast<std::uint32_t>(task.vertices.size());
        const std::uint32_t copy = flat ? next : copies.try_emplace(corner, next).first->second;
        if (copy == next) task.vertices.push_back(corner);
        task.mesh.indices.push_back(first + copy);
    }
}

void addPositions(const PrimitiveTask& task, const AccessorView& positions) {
    for (const std::uint32_t vertex : task.vertices) {
        const glm::dvec3 p(task.transform * glm::dvec4(readVec3(positions, vertex), 1.0));
        // Written so that NaN fails.
        if (!(std::abs(p.x) <= maxCoordinate && std::abs(p.y) <= maxCoordinate &&
              std::abs(p.z) <= maxCoordinate))
            task.file.fail(fmt::format("{}.attributes.POSITION[{}]", task.place, vertex),
                           fmt::format("finite coordinates of at most {:g} m", maxCoordinate),
                           fmt::format("{:g}, {:g}, {:g}", p.x, p.y, p.z));
        task.mesh.positions.push_back(p);
    }
}

glm::dvec3 faceNormal(const Mesh& mesh, std::size_t firstIndex) {
    const glm::dvec3& a = mesh.positions[mesh.indices[firstIndex]];
    const glm::dvec3& b = mesh.positions[mesh.indices[firstIndex + 1]];
    const glm::dvec3& c = mesh.positions[mesh.indices[firstIndex + 2]];
    return glm::cross(b - a, c - a);
}

/// Unit length, or none for a vector that has no direction.
std::optional<glm::vec3> unit(const glm::dvec3& v) {
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (!(largest > 0) || !std::isfinite(largest)) return std::nullopt;
    return glm::vec3(glm::normalize(v / largest)); // no overflow or underflow in the squares
}

/// For the vertices marked in `missing`: from the faces around them, by area. A vertex of degenerate faces
/// only gets some direction.
void addFaceNormals(PrimitiveTask& task, std::size_t firstIndex, const std::vector<bool>& missing) {
    Mesh& mesh = task.mesh;
    std::vector<glm::dvec3> sums(task.vertices.size(), glm::dvec3(0));
    for (std::size_t i = firstIndex; i < mesh.indices.size(); i += 3)
        for (std::size_t c = 0; c < 3; ++c)
            sums[mesh.indices[i + c] - task.firstVertex] += faceNormal(mesh, i);
    for (std::size_t v = 0; v < sums.size(); ++v)
        if (missing[v]) mesh.normals[task.firstVertex + v] = unit(sums[v]).value_or(glm::vec3(0, 1, 0));
}

/// Transforms by the cofactors, which unlike the inverse exist for every matrix.
void addNormals(PrimitiveTask& task, const std::optional<AccessorView>& normals, std::size_t firstIndex) {
    const glm::dmat3 m(task.transform);
    const double sign = glm::determinant(m) < 0 ? -1.0 : 1.0;
    const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    std::vector<bool> missing(task.vertices.size(), false);
    for (std::size_t v = 0; v < task.vertices.size(); ++v) {
        const std::optional<glm::vec3> normal =
            normals ? unit(sign * (cofactors * readVec3(*normals, task.vertices[v]))) : std::nullopt;
        missing[v] = !normal;
        task.mesh.normals.push_back(normal.value_or(glm::vec3(0)));
    }
    if (std::find(missing.begin(), missing.end(), true) != missing.end())
        addFaceNormals(task, firstIndex, missing);
}

void addUvs(PrimitiveTask& task, std::size_t count) {
    const TextureMapping mapping = textureMapping(task.file, task.primitive.material);
    const std::optional<AccessorView> uvs =
        attribute(task, fmt::format("TEXCOORD_{}", mapping.texCoord), uvKind(), count);
    for (const std::uint32_t vertex : task.vertices) {
        glm::vec2 uv(0);
        if (uvs)
            uv = glm::vec2(mapping.transform *
                           glm::dvec3(uvs->component(vertex, 0), uvs->component(vertex, 1), 1));
        task.mesh.uvs.push_back(std::isfinite(uv.x) && std::isfinite(uv.y) ? uv : glm::vec2(0));
    }
}

void addPart(Mesh& mesh, std::size_t firstIndex, int material) {
    const auto count = static_cast<std::uint32_t>(mesh.indices.size() - firstIndex);
    if (!mesh.parts.empty() && mesh.parts.back().material == material)
        mesh.parts.back().indexCount += count;
    else
        mesh.parts.push_back({static_cast<std::uint32_t>(firstIndex), count, material});
}

void addPrimitive(PrimitiveTask task) {
    const std::optional<AccessorView> positions = attribute(task, "POSITION", positionKind());
    if (!positions) return;
    Mesh& mesh = task.mesh;
    const std::size_t firstIndex = mesh.indices.size();
    std::vector<std::uint32_t> corners =
        triangleCorners(task.file, task.place, task.primitive, positions->count(), maxCorners - firstIndex);
    if (corners.empty()) return;
    if (glm::determinant(glm::dmat3(task.transform)) < 0) // a mirror turns front into back
        for (std::size_t i = 0; i < corners.size(); i += 3)
            std::swap(corners[i + 1], corners[i + 2]);
    const std::optional<AccessorView> normals = attribute(task, "NORMAL", normalKind(), positions->count());
    addIndices(task, corners, !normals);
    addPositions(task, *positions);
    addNormals(task, normals, firstIndex);
    addUvs(task, positions->count());
    addPart(mesh, firstIndex, materialIndex(task.file, task.place, task.primitive));
}

} // namespace

Mesh loadGltf(const std::filesystem::path& path) {
    const GltfFile file = readGltfFile(path);
    Mesh mesh;
    for (const MeshInstance& instance : sceneMeshes(file)) {
        const auto& primitives = file.model.meshes[static_cast<std::size_t>(instance.mesh)].primitives;
        for (std::size_t i = 0; i < primitives.size(); ++i)
            addPrimitive({file, fmt::format("meshes[{}].primitives[{}]", instance.mesh, i), primitives[i],
                          instance.transform, mesh, mesh.positions.size()});
    }
    if (mesh.indices.empty()) file.fail("scene", "a mesh with triangles", "no triangles");
    addMaterials(file, mesh);
    return mesh;
}

} // namespace limpid::io
