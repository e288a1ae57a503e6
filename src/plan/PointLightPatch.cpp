#include "plan/PointLightPatch.h"

#include <algorithm>
#include <cmath>

#include "plan/WaveTerms.h"

namespace limpid {

namespace {

/// A point light that touches the water would take lines without end, and single precision none of them.
constexpr int mostHalvings = 16;

/// Lines along one axis, on which the point light is `at`; it is `above` the highest crest, m.
class Lines {
  public:
    Lines(double at, double above) : _at(at), _above(above) {}

    /// Adds the ends of the parts of a stretch but for its begin.
    void add(double low, double high, int halvings = mostHalvings) {
        const double aside = std::max({low - _at, _at - high, 0.0});
        if (halvings == 0 || high - low <= pointLightTurn * std::hypot(_above, aside)) {
            found.push_back(high);
            return;
        }
        const double middle = 0.5 * (low + high);
        add(low, middle, halvings - 1);
        add(middle, high, halvings - 1);
    }

    std::vector<double> found{0};

  private:
    double _at, _above;
};

} // namespace

std::optional<WaterPatch> pointLightPatch(const Light& light, const Water& water, const WaterPatch& patch) {
    if (light.type != LightType::Point || !entersWater(light, water)) return std::nullopt;
    const glm::dvec2 at = glm::dvec2(light.position.x, light.position.z) - patch.min();
    const double above = light.position.y - water.level - highestWave(water);
    WaterPatch fine = patch;
    for (const int axis : {0, 1}) {
        Lines lines(at[axis], above);
        for (int i = 0; i < patch.grid[axis]; ++i)
            lines.add(patch.size[axis] * i / patch.grid[axis], patch.size[axis] * (i + 1) / patch.grid[axis]);
        fine.grid[axis] = int(lines.found.size()) - 1;
        fine.lines[std::size_t(axis)] = std::move(lines.found);
    }
    if (fine.grid == patch.grid) return std::nullopt;
    return fine;
}

} // namespace limpid
