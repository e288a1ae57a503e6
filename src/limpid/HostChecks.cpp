#include "limpid/HostChecks.h"

#include <fmt/format.h>

#include "core/Error.h"
#include "gl/Api.h"

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

} // namespace

void requireHostTextures(const Water& water) {
    for (std::size_t i = 0; i < water.waves.size(); ++i)
        if (const Wave& wave = water.waves[i]; wave.heights && wave.heights->texture() != 0)
            requireTexture(fmt::format("water.waves[{}]: HostWater::texture", i), wave.heights->texture(),
                           wave.heights->bounds().size);
}

} // namespace limpid
