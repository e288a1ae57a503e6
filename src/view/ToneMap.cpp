#include <algorithm>
#include <cmath>

#include "view/Picture.h"

namespace limpid {

namespace {
namespace shader {
using namespace glm;
#include "optics/tonemap.glsl"
} // namespace shader
// An even spread of [0, 1) over pixels (R2 sequence, Roberts 2018): dithers without a pattern that the eye
// finds.
float dither(std::size_t pixel, std::size_t width) {
    const double x = double(pixel % width), y = double(pixel / width);
    const double value = 0.7548776662466927 * x + 0.5698402909980532 * y;
    return float(value - std::floor(value));
}

// Keeps values that are whole steps but for rounding at their step where the dither adds nothing.
constexpr float rounding = 1e-3f;
} // namespace

std::vector<std::uint8_t> toneMapped(const Picture& picture, double exposure) {
    std::vector<std::uint8_t> out(picture.rgb.size());
    const float gain = float(std::exp2(exposure));
    for (std::size_t i = 0; i + 2 < picture.rgb.size(); i += 3) {
        const glm::vec3 linear(picture.rgb[i], picture.rgb[i + 1], picture.rgb[i + 2]);
        const glm::vec3 shown = shader::reinhard(gain * linear, whiteLuminance);
        const float offset = dither(i / 3, std::size_t(std::max(picture.size.x, 1)));
        for (int c = 0; c < 3; ++c) {
            const float value = shader::srgbEncode(std::clamp(shown[c], 0.0f, 1.0f));
            out[i + std::size_t(c)] = std::uint8_t(std::min(255.0f * value + offset + rounding, 255.0f));
        }
    }
    return out;
}

} // namespace limpid
