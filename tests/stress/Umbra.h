#pragma once
#include <cmath>
#include <optional>
#include <string>

#include "engine/EngineFixture.h"
#include "reference/ReferenceJob.h"

/// What the flux balance cannot show, for it follows the very beams that maps are filled with: that too much
/// or too little enters, and light where there can be none. Both are told by the ray-traced reference.
namespace limpid::stress {

class Umbra {
  public:
    explicit Umbra(const Scene& scene) : _job(reference::referenceJob(scene, 0)) {
        _truth = reference::traceLight(_job, {photons, 1, 0, {}});
        for (std::size_t m = 0; m < _truth.maps.size(); ++m)
            _dark.push_back(darkTexels(m));
    }

    /// What enters of all lights, less what does in the reference, over that.
    double enteringError(const Baked& baked) const {
        double ours = 0, theirs = 0;
        for (std::size_t i = 0; i < baked.flux.size(); ++i)
            ours += baked.flux[i].entering, theirs += _truth.lights[i].entering;
        return theirs > 0 ? ours / theirs - 1 : ours;
    }

    /// Mean irradiance of the umbra's texels over that of all others; none if there is no umbra.
    std::optional<double> light(const Baked& baked) const {
        double inside = 0, outside = 0;
        std::int64_t dark = 0, lit = 0;
        for (std::size_t m = 0; m < baked.maps.size(); ++m)
            for (std::size_t i = 0; i < _dark[m].size(); ++i) {
                if (_truth.maps[m].position[4 * i + 3] == 0) continue;
                (_dark[m][i] ? inside : outside) += meanOf(baked.maps[m].irradiance, i);
                ++(_dark[m][i] ? dark : lit);
            }
        if (dark == 0 || lit == 0 || outside == 0) return {};
        return (inside / double(dark)) / (outside / double(lit));
    }

  private:
    static constexpr std::int64_t photons = 2'000'000;

    static double meanOf(const std::vector<float>& rgb, std::size_t texel) {
        const float* at = &rgb[3 * texel];
        return (double(at[0]) + double(at[1]) + double(at[2])) / 3;
    }
    /// The reference says 0 here and in the eight texels around, all of which see the receiver. None in a map
    /// whose texels are so small that chance alone may leave them dark.
    std::vector<bool> darkTexels(std::size_t m) const {
        const TexelFrame& frame = _job.maps[m].frame;
        const glm::ivec2 size = frame.size;
        std::vector<bool> dark(std::size_t(size.x) * std::size_t(size.y));
        if (double(photons) * frame.texelArea() < 8 * _job.patchSize.x * _job.patchSize.y) return dark;
        for (int y = 1; y + 1 < size.y; ++y)
            for (int x = 1; x + 1 < size.x; ++x) {
                bool all = true;
                for (int k = 0; k < 9 && all; ++k) {
                    const std::size_t i = std::size_t((y + k / 3 - 1) * size.x + x + k % 3 - 1);
                    all =
                        _truth.maps[m].position[4 * i + 3] == 1 && meanOf(_truth.maps[m].irradiance, i) == 0;
                }
                dark[std::size_t(y * size.x + x)] = all;
            }
        return dark;
    }

    reference::TraceJob _job;
    reference::TraceResult _truth;
    std::vector<std::vector<bool>> _dark; ///< of each map
};

} // namespace limpid::stress
