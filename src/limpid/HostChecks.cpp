#include "limpid/HostChecks.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/Error.h"
#include "gl/Api.h"
#include "scene/HostMesh.h"

namespace limpid {

namespace {

void requireTexture(const std::string& place, GLuint texture, glm::ivec2 texels) {
    if (!glIsTexture(texture))
        throw InputError(
            fmt::format("{}: expected an OpenGL texture, got {}, which names none", place, texture));
    GLint target = 0, format = 0;
    glm::ivec2 size(0);
    glGetTextureParameteriv(texture, GL_TEXTURE_TARGET, &target);
    if (target != GL_TEXTURE_2D)
        throw InputError(fmt::format("{}: expected target GL_TEXTURE_2D ({:#x}), got {:#x}", place,
                                     GL_TEXTURE_2D, target));
    glGetTextureLevelParameteriv(texture, 0, GL_TEXTURE_INTERNAL_FORMAT, &format);
    if (format != GL_R32F)
        throw InputError(
            fmt::format("{}: expected format GL_R32F ({:#x}), got {:#x}", place, GL_R32F, format));
    glGetTextureLevelParameteriv(texture, 0, GL_TEXTURE_WIDTH, &size.x);
    glGetTextureLevelParameteriv(texture, 0, GL_TEXTURE_HEIGHT, &size.y);
    if (size != texels)
        throw InputError(fmt::format("{}: expected {} x {} texels, got {} x {}", place, texels.x, texels.y,
                                     size.x, size.y));
}

/// `end`: bytes that are read, from the buffer's first on.
void requireBuffer(const std::string& place, GLuint buffer, std::int64_t end) {
    if (!glIsBuffer(buffer))
        throw InputError(
            fmt::format("{}: expected an OpenGL buffer, got {}, which names none", place, buffer));
    GLint64 bytes = 0;
    GLint mapped = 0;
    glGetNamedBufferParameteri64v(buffer, GL_BUFFER_SIZE, &bytes);
    if (bytes < end)
        throw InputError(fmt::format("{}: expected at least {} bytes, got {}", place, end, bytes));
    glGetNamedBufferParameteriv(buffer, GL_BUFFER_MAPPED, &mapped);
    if (mapped) throw InputError(fmt::format("{}: expected an unmapped buffer, got a mapped one", place));
}

/// A pass reads it as one block, and writes another.
void requireRoom(const std::string& place, const HostMesh& mesh) {
    GLint64 most = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
    const std::int64_t vertices = std::int64_t(mesh.vertexCount) * std::max(mesh.vertexStride, 48),
                       indices = std::int64_t(mesh.indexCount) * 4;
    if (const std::int64_t bytes = std::max(mesh.vertexOffset + vertices, mesh.indexOffset + indices);
        bytes > most)
        throw InputError(
            fmt::format("{}: expected at most {} bytes with this GPU, got {}", place, most, bytes));
}

void requireBuffers(const std::string& place, const HostMesh& mesh) {
    requireRoom(place, mesh);
    const int last = std::max(mesh.positionOffset, mesh.normalOffset.value_or(0));
    requireBuffer(place + ".vertexBuffer", mesh.vertexBuffer,
                  mesh.vertexOffset + std::int64_t(mesh.vertexCount - 1) * mesh.vertexStride + last + 12);
    if (!mesh.indexBuffer) return;
    const std::int64_t indices = mesh.indexOffset + std::int64_t(mesh.indexCount) * mesh.indexBytes;
    requireBuffer(place + ".indexBuffer", mesh.indexBuffer, (indices + 3) / 4 * 4); // read in words
}

} // namespace

void requireHostBuffers(const std::vector<Receiver>& receivers) {
    for (std::size_t i = 0; i < receivers.size(); ++i)
        if (receivers[i].host) requireBuffers(fmt::format("receivers[{}]: HostMesh", i), *receivers[i].host);
}

void requireHostTextures(const Water& water) {
    for (std::size_t i = 0; i < water.waves.size(); ++i)
        if (const Wave& wave = water.waves[i]; wave.heights && wave.heights->texture() != 0)
            requireTexture(fmt::format("water.waves[{}]: HostWater::texture", i), wave.heights->texture(),
                           wave.heights->bounds().size);
}

} // namespace limpid
