#include "Water.h"

#include <cmath>

#include <glm/gtc/constants.hpp>

#include "Shaders.h"

namespace {

enum Uniform { Seconds, Size, WaveCount, Waves = 4 };
constexpr glm::ivec2 texels(256);
const glm::vec2 size(5); // m

struct Sine {
    glm::vec2 direction; ///< of any length
    float length;        ///< m, from crest to crest
};
const Sine sines[] = {{{1, 0.3f}, 0.55f}, {{-0.4f, 1}, 0.41f}, {{0.7f, -0.8f}, 0.33f}};

float amplitudeOf(const Sine& sine) {
    return 0.012f * sine.length;
}

/// As water.comp has it.
glm::vec4 uniformOf(const Sine& sine) {
    const float k = glm::two_pi<float>() / sine.length;
    return {k * glm::normalize(sine.direction), amplitudeOf(sine), std::sqrt(9.81f * k)};
}

limpid::HostWater describe(GLuint heights) {
    limpid::HostWater water;
    water.texture = heights;
    water.texels = texels;
    water.size = size;
    water.highest = water.steepest = 0;
    for (const Sine& sine : sines) {
        water.highest += double(amplitudeOf(sine));
        water.steepest += double(amplitudeOf(sine) * glm::two_pi<float>() / sine.length);
    }
    return water;
}

} // namespace

Water::Water() : _program(makeProgram({"water.comp"})) {
    glCreateTextures(GL_TEXTURE_2D, 1, &_heights);
    glTextureStorage2D(_heights, 1, GL_R32F, texels.x, texels.y);
    _wave = limpid::waveOf(describe(_heights));
}

Water::~Water() {
    glDeleteTextures(1, &_heights);
    glDeleteProgram(_program);
}

void Water::move(double seconds) const {
    glUseProgram(_program);
    glUniform1f(Seconds, float(seconds));
    glUniform2fv(Size, 1, &size.x);
    glUniform1i(WaveCount, GLint(std::size(sines)));
    for (std::size_t i = 0; i < std::size(sines); ++i) {
        const glm::vec4 wave = uniformOf(sines[i]);
        glUniform4fv(Waves + GLint(i), 1, &wave.x);
    }
    glBindImageTexture(0, _heights, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32F);
    glDispatchCompute(GLuint(texels.x + 7) / 8, GLuint(texels.y + 7) / 8, 1);
}
