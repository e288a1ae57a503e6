#include "levelmap/ReceiverGeometry.h"

#include <array>

namespace limpid {

namespace {
struct Vertex {
    glm::vec3 position, normal;
    glm::vec2 uv;
};
constexpr GLint baseColorFactorLocation = 16;

std::vector<Vertex> worldVertices(const Receiver& receiver, const glm::dvec3& origin) {
    const Mesh& mesh = *receiver.mesh;
    std::vector<Vertex> vertices(mesh.positions.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const glm::dvec3 normal = receiver.rotation * (glm::dvec3(mesh.normals[i]) / receiver.scale);
        const double length = glm::length(normal);
        vertices[i] = {glm::vec3(receiver.toWorld(mesh.positions[i]) - origin),
                       length > 0 ? glm::vec3(normal / length) : glm::vec3(0, 1, 0), mesh.uvs[i]};
    }
    return vertices;
}
} // namespace

ReceiverGeometry::ReceiverGeometry(gl::Context& context, const Receiver& receiver, const glm::dvec3& origin)
    : _parts(receiver.mesh->parts), _materials(receiver.mesh->materials) {
    gl::Ledger& ledger = context.ledger();
    const auto vertices = worldVertices(receiver, origin);
    _vertices = gl::Buffer(ledger, "meshes", std::span<const Vertex>(vertices));
    _indices = gl::Buffer(ledger, "meshes", std::span<const std::uint32_t>(receiver.mesh->indices));
    _vertexArray.attribute(0, _vertices, 3, offsetof(Vertex, position), sizeof(Vertex));
    _vertexArray.attribute(1, _vertices, 3, offsetof(Vertex, normal), sizeof(Vertex));
    _vertexArray.attribute(2, _vertices, 2, offsetof(Vertex, uv), sizeof(Vertex));
    _vertexArray.indices(_indices);
    uploadImages(ledger, *receiver.mesh);
}

void ReceiverGeometry::uploadImages(gl::Ledger& ledger, const Mesh& mesh) {
    for (const Image& image : mesh.images) {
        gl::Texture texture(ledger, "textures", GL_SRGB8_ALPHA8,
                            {std::max(image.width, 1), std::max(image.height, 1)});
        if (image.width > 0) texture.upload(GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
        texture.setFilter(GL_LINEAR, GL_REPEAT);
        _images.push_back(std::move(texture));
    }
    _white = gl::Texture(ledger, "textures", GL_SRGB8_ALPHA8, {1, 1});
    constexpr std::array<std::uint8_t, 4> white{255, 255, 255, 255};
    _white.upload(GL_RGBA, GL_UNSIGNED_BYTE, white.data());
}

void ReceiverGeometry::draw(const gl::Program& program, GLenum primitive) const {
    program.use();
    _vertexArray.bind();
    for (const MeshPart& part : _parts) {
        const Material& material = _materials[std::size_t(part.material)];
        program.set(baseColorFactorLocation, material.baseColor);
        (material.baseColorImage >= 0 ? _images[std::size_t(material.baseColorImage)] : _white).bind(0);
        glDrawElements(
            primitive, GLsizei(part.indexCount), GL_UNSIGNED_INT,
            reinterpret_cast<const void*>(std::uintptr_t(part.firstIndex) * sizeof(std::uint32_t)));
    }
}

std::vector<glm::dvec3> submergedPoints(const Receiver& receiver, double level) {
    std::vector<glm::dvec3> world, wet;
    const Mesh& mesh = *receiver.mesh;
    for (const glm::dvec3& p : mesh.positions) {
        world.push_back(receiver.toWorld(p));
        if (world.back().y <= level) wet.push_back(world.back());
    }
    if (wet.empty() || wet.size() == world.size()) return wet;
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
        const glm::dvec3 &a = world[mesh.indices[i]], &b = world[mesh.indices[next]];
        if ((a.y <= level) == (b.y <= level)) continue;
        wet.push_back(a + (b - a) * ((level - a.y) / (b.y - a.y)));
    }
    return wet;
}

} // namespace limpid
