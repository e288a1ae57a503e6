#include "scene/HostWater.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/Error.h"

namespace limpid {

namespace {

constexpr int minSide = 16;

class HostHeights : public HeightSource {
  public:
    HostHeights(std::uint32_t texture, const HeightBounds& bounds) : _texture(texture), _bounds(bounds) {}

    int frameCount() const override { return 1; }
    std::shared_ptr<const HeightField> frame(int) override {
        throw InputError("HostWater: expected heights in memory, got a texture of a host's");
    }
    const HeightBounds& bounds() const override { return _bounds; }
    std::uint32_t texture() const override { return _texture; }

  private:
    std::uint32_t _texture;
    HeightBounds _bounds;
};

void requirePositive(const char* name, double value) {
    if (!(std::isfinite(value) && value > 0))
        throw InputError(fmt::format("HostWater::{}: expected a finite number > 0, got {}", name, value));
}

void require(const HostWater& water) {
    if (water.texture == 0) throw InputError("HostWater::texture: expected an OpenGL texture, got 0");
    for (const int side : {water.texels.x, water.texels.y})
        if (side < minSide || side > HeightField::maxSide)
            throw InputError(fmt::format("HostWater::texels: expected {} to {} a side, got {}", minSide,
                                         HeightField::maxSide, side));
    for (const double place : {water.center.x, water.center.y})
        if (!std::isfinite(place))
            throw InputError(fmt::format("HostWater::center: expected finite numbers, got {}", place));
    requirePositive("size", water.size.x);
    requirePositive("size", water.size.y);
    requirePositive("highest", water.highest);
    requirePositive("steepest", water.steepest);
}

} // namespace

Wave waveOf(const HostWater& water) {
    require(water);
    HeightBounds bounds;
    bounds.size = water.texels;
    bounds.highest = water.highest;
    bounds.steepest = water.steepest / std::numbers::sqrt2 * water.size / glm::dvec2(water.texels);
    Wave wave;
    wave.type = WaveType::HeightMap;
    wave.amplitude = 1;
    wave.center = water.center;
    wave.size = water.size;
    wave.heights = std::make_shared<HostHeights>(water.texture, bounds);
    return wave;
}

} // namespace limpid
