#include "water/SpectralWaves.h"

#include <cmath>
#include <vector>

#include "gl/GLFixture.h"
#include "scene/SlowWaves.h"
#include "water/WaterSurface.h"

namespace limpid {
namespace {

Water seaOf(double amplitude, const Wind& wind) {
    Water water;
    Wave& wave = water.waves.emplace_back();
    wave.type = WaveType::Phillips;
    wave.amplitude = amplitude;
    wave.spectrum = phillipsSpectrum(wind);
    return water;
}

class SpectralWavesGLTest : public GLTest {
  protected:
    struct Vertices {
        std::vector<glm::vec4> positions, normals;
    };
    static Vertices surfaceOf(const Water& water, const WaterPatch& patch, double time,
                              const glm::dvec3& origin = {}) {
        WaterSurface surface(context());
        surface.update(water, patch, origin, time);
        const auto count = std::size_t(surface.mesh().vertexCount);
        return {surface.mesh().positions.read<glm::vec4>(count),
                surface.mesh().normals.read<glm::vec4>(count)};
    }
};

/// Largest errors over all vertices: of height in root mean square heights, of slope in such slopes.
glm::dvec2 worst(const SpectralWavesGLTest&, const std::vector<glm::vec4>& positions,
                 const std::vector<glm::vec4>& normals, const Water& water, const glm::dvec3& origin,
                 double time) {
    const Wave& wave = water.waves[0];
    glm::dvec2 errors(0);
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const glm::dvec2 place = glm::dvec2(positions[i].x, positions[i].z) + glm::dvec2(origin.x, origin.z);
        const glm::dvec3 truth = wave.amplitude * test::slowWaves(*wave.spectrum, place, time);
        const glm::dvec2 slope = -glm::dvec2(normals[i].x, normals[i].z) / double(normals[i].y);
        errors = glm::max(
            errors, {std::abs(double(positions[i].y) - truth.x), glm::distance(slope, {truth.y, truth.z})});
    }
    return errors / wave.amplitude / glm::dvec2(1, wave.spectrum->rmsSlope);
}

TEST_F(SpectralWavesGLTest, equalTheSlowTransform) {
    const WaterPatch patch{{0.4, -0.3}, {3.1, 2.3}, {37, 29}};
    const glm::dvec3 origin(1024, 0, -512);
    for (const int modes : {16, 64}) {
        const Water water = seaOf(0.004, {.velocity = {3, 1}, .tile = {3, 2}, .modes = modes, .seed = 7});
        for (const double time : {0.0, -86400.7, 1e7 + 0.3}) {
            const Vertices v = surfaceOf(
                water, {patch.center + glm::dvec2(1024, -512), patch.size, patch.grid}, time, origin);
            const glm::dvec2 errors = worst(*this, v.positions, v.normals, water, origin, time);
            printf("%d modes at %.1f s: height %.2g, slope %.2g of the root mean square\n", modes, time,
                   errors.x, errors.y);
            EXPECT_LT(errors.x, 1e-5);
            EXPECT_LT(errors.y, 1e-3);
        }
    }
}

TEST_F(SpectralWavesGLTest, haveTheirEnergyAndRepeat) {
    const double amplitude = 0.01;
    const Water water = seaOf(amplitude, {.velocity = {2, -1}, .tile = {2, 2}, .modes = 32});
    const Vertices v = surfaceOf(water, {{1, 1}, {4, 2}, {128, 64}}, 3);
    double square = 0;
    for (std::size_t z = 0; z < 64; ++z)
        for (std::size_t x = 0; x < 64; ++x) {
            const double here = double(v.positions[z * 129 + x].y);
            square += here * here / (64 * 64);
            // A tile is a power of two here, so that places and with them bits repeat.
            EXPECT_EQ(v.positions[z * 129 + x].y, v.positions[z * 129 + x + 64].y);
            EXPECT_EQ(v.normals[z * 129 + x], v.normals[z * 129 + x + 64]);
        }
    EXPECT_NEAR(std::sqrt(square), amplitude, 1e-5 * amplitude);
    for (std::size_t x = 0; x <= 128; ++x)
        EXPECT_EQ(v.positions[x].y, v.positions[64 * 129 + x].y);
}

TEST_F(SpectralWavesGLTest, moveAndRest) {
    gl::Context& gl = context();
    const Water water = seaOf(0.01, {.modes = 8});
    WaterSurface surface(gl);
    const WaterPatch patch{{0, 0}, {1, 1}, {4, 4}};
    const auto heightAt = [&](double time) {
        surface.update(water, patch, {}, time);
        return surface.mesh().positions.read<glm::vec4>(1, 12)[0].y;
    };
    const float first = heightAt(0);
    EXPECT_NE(heightAt(0.5), first);
    EXPECT_EQ(heightAt(0), first);
}

} // namespace
} // namespace limpid
