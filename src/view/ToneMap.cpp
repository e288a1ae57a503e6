#include <algorithm>
#include <cmath>

#include "view/Picture.h"

namespace limpid {

namespace {
namespace shader {
using namespace glm;
#include "include/tonemap.glsl"
} // namespace shader
// A white wall in the default sun stays below this; only a caustic's core reaches it.
constexpr float white = 4.0f;
} // namespace

std::vector<std::uint8_t> toneMapped(const Picture& picture, double exposure) {
    std::vector<std::uint8_t> out(picture.rgb.size());
    const float gain = float(std::exp2(exposure));
    for (std::size_t i = 0; i + 2 < picture.rgb.size(); i += 3) {
        const glm::vec3 linear(picture.rgb[i], picture.rgb[i + 1], picture.rgb[i + 2]);
        const glm::vec3 shown = shader::reinhard(gain * linear, white);
        for (int c = 0; c < 3; ++c) {
            const float value = shader::srgbEncode(std::clamp(shown[c], 0.0f, 1.0f));
            out[i + std::size_t(c)] = std::uint8_t(std::lround(value * 255.0f));
        }
    }
    return out;
}

} // namespace limpid
