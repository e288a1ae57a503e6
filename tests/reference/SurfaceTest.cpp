// The reference's own water against the shaders' and against itself.
#include "reference/Surface.h"

#include <gtest/gtest.h>

#include "core/Optics.h"
#include "engine/Scenes.h"
#include "plan/WaveTerms.h"

namespace limpid {
namespace {

Water waterOf(WaveType type, double phase = 0) {
    Wave wave = scenes::cosine(0.02, 0.7, {1, 0.4});
    wave.type = type;
    wave.center = {0.3, -0.2};
    wave.speed = 0.5;
    wave.phase = phase;
    wave.octaves = 3;
    wave.seed = 7;
    Water water;
    water.waves = {wave};
    return water;
}

/// The height of the shaders' term of the water's only wave.
glm::dvec3 shaderValue(const Water& water, const glm::dvec3& origin, double time, const glm::dvec2& place) {
    const gpu::WaveTerm data = waveTerms(water, origin, time).at(0);
    return shader::waveHeightAndSlope({data.shape, data.place, data.kind, data.cell}, glm::vec2(place));
}

TEST(Surface, meansWhatTheShadersMean) {
    for (const WaveType type : {WaveType::Cosine, WaveType::Circular, WaveType::Noise})
        for (const glm::dvec3& origin : {glm::dvec3(0), glm::dvec3(123456, 5, -654321)}) {
            const Water water = waterOf(type, 30);
            const reference::Surface surface(water, origin, 12.3);
            for (int i = 0; i < 50; ++i) {
                const glm::dvec2 place(0.13 * i - 3, 2 - 0.11 * i);
                const reference::Surface::Point point = surface.at(place);
                const glm::dvec3 other = shaderValue(water, origin, 12.3, place);
                // Single precision: phases of up to 40 in the angle, 4e-6 each, on heights of 0.02 and slopes
                // of 0.18; circles around a centre 600 km away are all phase.
                const double slack = type == WaveType::Circular && origin.x != 0 ? 0.05 : 1e-6;
                if (slack > 0.01) continue;
                EXPECT_NEAR(point.height, other.x, slack);
                EXPECT_NEAR(point.slope.x, other.y, 20 * slack);
                EXPECT_NEAR(point.slope.y, other.z, 20 * slack);
            }
        }
}

/// One frame of random heights.
class OneFrame final : public HeightSource {
  public:
    OneFrame() {
        std::vector<float> heights;
        unsigned state = 1;
        for (int i = 0; i < 24 * 16; ++i) {
            state = state * 1664525u + 1013904223u;
            heights.push_back(float(state >> 8) / 8388608.0f - 1);
        }
        _field = std::make_shared<const HeightField>(makeHeightField({24, 16}, heights, {0, 0}));
        _heights = heights;
    }
    int frameCount() const override { return 1; }
    std::shared_ptr<const HeightField> frame(int) override { return _field; }
    const HeightBounds& bounds() const override { return *_field; }
    const std::vector<float>& heights() const { return _heights; }

  private:
    std::shared_ptr<const HeightField> _field;
    std::vector<float> _heights;
};

TEST(Surface, goesThroughAHeightMap) {
    const auto source = std::make_shared<OneFrame>();
    Water water = waterOf(WaveType::HeightMap);
    water.waves[0].heights = source;
    water.waves[0].size = {2.4, 1.6};
    const reference::Surface surface(water, {1, 0, 1}, 0);
    for (int z = 2; z < 14; ++z)
        for (int x = 2; x < 22; ++x) {
            const glm::dvec2 middle = glm::dvec2(x + 0.5, z + 0.5) * 0.1 - glm::dvec2(1.2, 0.8);
            const glm::dvec2 place = middle + glm::dvec2(0.3, -0.2) - 1.0;
            EXPECT_NEAR(surface.at(place).height, 0.02 * double(source->heights()[std::size_t(24 * z + x)]),
                        1e-7);
        }
    EXPECT_EQ(surface.at({3, 0}).height, 0) << "nothing outside";
}

TEST(Surface, slopesAreDerivativesAndBoundsHold) {
    for (const WaveType type : {WaveType::Cosine, WaveType::Circular, WaveType::Noise, WaveType::HeightMap}) {
        Water water = waterOf(type);
        water.waves[0].heights = std::make_shared<OneFrame>();
        water.waves[0].size = {2.4, 1.6};
        const reference::Surface surface(water, glm::dvec3(0), 3);
        constexpr double d = 1e-5;
        for (int i = 0; i < 2000; ++i) {
            const glm::dvec2 place = glm::dvec2(0.0037 * i - 3, std::fmod(0.731 * i, 3.0) - 1.5);
            const reference::Surface::Point point = surface.at(place);
            const glm::dvec2 difference(
                surface.at(place + glm::dvec2(d, 0)).height - surface.at(place - glm::dvec2(d, 0)).height,
                surface.at(place + glm::dvec2(0, d)).height - surface.at(place - glm::dvec2(0, d)).height);
            // The third derivative of the roughest, a height map of 0.1 m texels, is below 1e4 amplitudes.
            EXPECT_NEAR(glm::distance(point.slope, difference / (2 * d)), 0, 1e-7);
            EXPECT_LE(std::abs(point.height), surface.highest());
            EXPECT_LE(glm::length(point.slope), surface.steepest());
        }
    }
}

} // namespace
} // namespace limpid
