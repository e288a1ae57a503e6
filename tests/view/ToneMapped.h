#pragma once
#include <cmath>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "core/Picture.h"
#include "view/PictureResolve.h"

namespace limpid {

namespace shader {
using namespace glm;
#include "optics/tonemap.glsl"
} // namespace shader

/// 8-bit sRGB of a picture as shaders/view/resolve.comp has it, on the CPU.
inline std::vector<std::uint8_t> toneMapped(const Picture& picture, double exposure) {
    std::vector<std::uint8_t> out;
    const float gain = float(std::exp2(exposure));
    for (std::size_t i = 0; i + 2 < picture.rgb.size(); i += 3) {
        const glm::vec3 linear(picture.rgb[i], picture.rgb[i + 1], picture.rgb[i + 2]);
        const auto pixel = unsigned(i / 3), width = unsigned(picture.size.x);
        const glm::vec3 steps = shader::displaySteps(shader::displayed(linear, gain, whiteLuminance),
                                                     {pixel % width, pixel / width});
        for (int c = 0; c < 3; ++c)
            out.push_back(std::uint8_t(steps[c]));
    }
    return out;
}

} // namespace limpid
