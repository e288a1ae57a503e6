#include "levelmap/ReceiverGeometry.h"

#include <algorithm>
#include <array>

#include "core/ShaderData.h"
#include "gl/Bindings.h"
#include "levelmap/HostTriangles.h"

namespace limpid {

namespace {
struct Vertex {
    glm::vec3 position, normal;
    glm::vec2 uv, normalUv;
    glm::u16vec4 color; // linear: eight bits would show steps in the dark
};
static_assert(sizeof(Vertex) == 4 * gpu::vertexWords); // which a host's mesh is written as, too

/// Share of the light that goes through what is there of the surface, about.
float meanThrough(const Material& material) {
    return material.transmission * (material.baseColor.r + material.baseColor.g + material.baseColor.b) / 3;
}

/// Alpha of something blended below which more than half of the light goes through.
float halfOpaque(const Material& material) {
    return 0.5f / std::max(1 - meanThrough(material), 0.25f);
}

GLenum wrapOf(Wrap wrap) {
    switch (wrap) {
    case Wrap::Repeat:
        return GL_REPEAT;
    case Wrap::Mirror:
        return GL_MIRRORED_REPEAT;
    case Wrap::Clamp:
        return GL_CLAMP_TO_EDGE;
    }
    return GL_REPEAT;
}

/// A texture is shared by materials; how it is read is each material's own.
void bindTexture(const gl::Texture& texture, GLuint unit, Wrap s, Wrap t, bool nearest = false) {
    texture.bind(unit);
    glTextureParameteri(texture.id(), GL_TEXTURE_WRAP_S, GLint(wrapOf(s)));
    glTextureParameteri(texture.id(), GL_TEXTURE_WRAP_T, GLint(wrapOf(t)));
    glTextureParameteri(texture.id(), GL_TEXTURE_MAG_FILTER, nearest ? GL_NEAREST : GL_LINEAR);
}

std::vector<Vertex> worldVertices(const Receiver& receiver, const glm::dvec3& origin) {
    const Mesh& mesh = *receiver.mesh;
    std::vector<Vertex> vertices(mesh.positions.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const glm::dvec3 normal = receiver.rotation * (glm::dvec3(mesh.normals[i]) / receiver.scale);
        const double length = glm::length(normal);
        vertices[i] = {glm::vec3(receiver.toWorld(mesh.positions[i]) - origin),
                       length > 0 ? glm::vec3(normal / length) : glm::vec3(0, 1, 0), mesh.uvs[i],
                       mesh.normalUvs.empty() ? mesh.uvs[i] : mesh.normalUvs[i],
                       mesh.colors.empty()
                           ? glm::u16vec4(65535)
                           : glm::u16vec4(glm::round(glm::clamp(mesh.colors[i], 0.0f, 1.0f) * 65535.0f))};
    }
    return vertices;
}

Bounds boundsOf(const Receiver& receiver, const MeshPart& part) {
    Bounds bounds;
    for (std::uint32_t i = 0; i < part.indexCount; ++i)
        bounds.add(receiver.toWorld(receiver.mesh->positions[receiver.mesh->indices[part.firstIndex + i]]));
    return bounds;
}
} // namespace

ReceiverGeometry::ReceiverGeometry(gl::Context& context, const Receiver& receiver, const glm::dvec3& origin)
    : _parts(receiver.mesh->parts), _materials(receiver.mesh->materials),
      _partlyBlended(isPartlyBlended(*receiver.mesh)) {
    gl::Ledger& ledger = context.ledger();
    if (receiver.host)
        takeHostMesh(context, receiver, origin);
    else
        uploadMesh(ledger, receiver, origin);
    _vertexArray.attribute(positionAttribute, _vertices, 3, offsetof(Vertex, position), sizeof(Vertex));
    _vertexArray.attribute(normalAttribute, _vertices, 3, offsetof(Vertex, normal), sizeof(Vertex));
    _vertexArray.attribute(uvAttribute, _vertices, 4, offsetof(Vertex, uv), sizeof(Vertex));
    _vertexArray.shortAttribute(colorAttribute, _vertices, offsetof(Vertex, color), sizeof(Vertex));
    _vertexArray.indices(_indices);
    findBlendedParts(receiver, origin);
}

void ReceiverGeometry::place(const Receiver& receiver, const glm::dvec3& origin) {
    const auto vertices = worldVertices(receiver, origin);
    _vertices.write(0, std::int64_t(vertices.size() * sizeof(Vertex)), vertices.data());
    findBlendedParts(receiver, origin);
}

void ReceiverGeometry::findBlendedParts(const Receiver& receiver, const glm::dvec3& origin) {
    _blendedParts.clear();
    for (std::size_t i = 0; i < _parts.size(); ++i) {
        const Material& material = _materials[std::size_t(_parts[i].material)];
        if (!isBlended(material)) continue;
        const glm::dvec3 center = boundsOf(receiver, _parts[i]).center();
        _blendedParts.push_back({i, glm::vec3(center - origin)});
    }
}

void ReceiverGeometry::uploadMesh(gl::Ledger& ledger, const Receiver& receiver, const glm::dvec3& origin) {
    const auto vertices = worldVertices(receiver, origin);
    _vertices = gl::Buffer(ledger, "meshes", std::span<const Vertex>(vertices));
    _indices = gl::Buffer(ledger, "meshes", std::span<const std::uint32_t>(receiver.mesh->indices));
    uploadImages(ledger, *receiver.mesh);
}

/// Its hull has been planned with; of that nothing is drawn.
void ReceiverGeometry::takeHostMesh(gl::Context& context, const Receiver& receiver,
                                    const glm::dvec3& origin) {
    HostTriangles triangles = hostTriangles(context, receiver, origin);
    _vertices = std::move(triangles.vertices);
    _indices = std::move(triangles.indices);
    _parts = {{0, std::uint32_t(triangles.indexCount), 0}};
    _materials.assign(1, {});
    _materials[0].baseColor = glm::vec4(receiver.host->albedo, 1);
    _partlyBlended = false;
    uploadImages(context.ledger(), {});
}

void ReceiverGeometry::uploadImages(gl::Ledger& ledger, const Mesh& mesh) {
    for (const Image& image : mesh.images) {
        const GLenum format = image.srgb ? GL_SRGB8_ALPHA8 : GL_RGBA8;
        const glm::ivec2 size(std::max(image.width, 1), std::max(image.height, 1));
        gl::Texture texture(ledger, "textures", format, size, gl::Mipmaps::Full);
        if (image.width > 0) texture.upload(GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
        texture.setFilter(GL_LINEAR, GL_REPEAT);
        _images.push_back(std::move(texture));
    }
    _white = gl::Texture(ledger, "textures", GL_SRGB8_ALPHA8, {1, 1});
    constexpr std::array<std::uint8_t, 4> white{255, 255, 255, 255};
    _white.upload(GL_RGBA, GL_UNSIGNED_BYTE, white.data());
}

void ReceiverGeometry::drawPart(std::size_t index, const gl::Program& program, GLenum primitive,
                                float cutoff) const {
    const MeshPart& part = _parts[index];
    const Material& material = _materials[std::size_t(part.material)];
    program.set(baseColorFactorLocation, material.baseColor);
    program.set(alphaCutoffLocation, cutoff);
    program.set(normalScaleLocation, material.normalImage >= 0 ? material.normalScale : 0.0f);
    bindTexture(material.baseColorImage >= 0 ? _images[std::size_t(material.baseColorImage)] : _white,
                baseColorTextureUnit, material.baseColorWrapS, material.baseColorWrapT,
                material.baseColorNearest);
    program.set(emissionFactorLocation, material.emission);
    bindTexture(material.emissionImage >= 0 ? _images[std::size_t(material.emissionImage)] : _white,
                emissionTextureUnit, material.emissionWrapS, material.emissionWrapT,
                material.emissionImage == material.baseColorImage && material.baseColorNearest);
    if (material.normalImage >= 0)
        bindTexture(_images[std::size_t(material.normalImage)], normalTextureUnit, material.normalWrapS,
                    material.normalWrapT);
    program.use();
    _vertexArray.bind();
    glDrawElements(primitive, GLsizei(part.indexCount), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(std::uintptr_t(part.firstIndex) * sizeof(std::uint32_t)));
}

void ReceiverGeometry::drawPart(std::size_t part, const gl::Program& program, GLenum primitive) const {
    program.set(transmissionLocation, _materials[std::size_t(_parts[part].material)].transmission);
    program.set(ofPartlyBlendedLocation, _partlyBlended ? 1 : 0);
    drawPart(part, program, primitive, 0);
}

void ReceiverGeometry::draw(const gl::Program& program, GLenum primitive) const {
    for (std::size_t i = 0; i < _parts.size(); ++i) {
        const Material& material = _materials[std::size_t(_parts[i].material)];
        if (material.alphaMode != AlphaMode::Blend && meanThrough(material) > 0.5f) continue;
        drawPart(i, program, primitive, holeAlpha(material, halfOpaque(material)));
    }
}

template <typename Prepare>
void ReceiverGeometry::drawShown(const gl::Program& program, const Prepare& prepare) const {
    for (std::size_t i = 0; i < _parts.size(); ++i) {
        const Material& material = _materials[std::size_t(_parts[i].material)];
        const float alpha = shownAlpha(material, _partlyBlended);
        if (alpha > 1 || (material.alphaMode != AlphaMode::Blend && meanThrough(material) >= 1)) continue;
        prepare(material);
        drawPart(i, program, GL_TRIANGLES, alpha);
    }
}

void ReceiverGeometry::drawShown(const gl::Program& program) const {
    drawShown(program, [](const Material&) {});
}

void ReceiverGeometry::drawTranslucence(const gl::Program& program) const {
    drawShown(program, [&](const Material& material) {
        program.set(transmissionLocation, material.transmission);
        program.set(blendedLocation, material.alphaMode == AlphaMode::Blend ? 1 : 0);
        bindTexture(material.transmissionImage >= 0 ? _images[std::size_t(material.transmissionImage)]
                                                    : _white,
                    transmissionTextureUnit, material.transmissionWrapS, material.transmissionWrapT);
    });
}

void ReceiverGeometry::drawSolid(const gl::Program& program, GLenum primitive) const {
    for (std::size_t i = 0; i < _parts.size(); ++i) {
        const Material& material = _materials[std::size_t(_parts[i].material)];
        if (material.transmission > 0) continue;
        drawPart(i, program, primitive, holeAlpha(material, solidAlpha));
    }
}

} // namespace limpid
