#include "water/HeightMaps.h"

#include <cmath>
#include <numbers>

#include "core/Error.h"
#include "engine/Scenes.h"
#include "gl/GLFixture.h"
#include "io/TempFolder.h"
#include "io/images/HeightImages.h"
#include "io/images/Images.h"
#include "plan/WaveTerms.h"
#include "water/WaterSurface.h"

namespace limpid {
namespace {

/// Frames in memory, and how often they were asked for.
class Frames : public HeightSource {
  public:
    std::vector<std::shared_ptr<const HeightField>> fields;
    int asked = 0;

    int frameCount() const override { return int(fields.size()); }
    const HeightBounds& bounds() const override { return *fields.front(); }
    std::shared_ptr<const HeightField> frame(int index) override {
        ++asked;
        return fields[std::size_t(index)];
    }
};

/// A height map over `size` m around `center` of `texels`, each frame filled from f(x, z) in m of the world.
template <typename... F>
Wave heightMap(glm::ivec2 texels, glm::dvec2 center, glm::dvec2 size, F... f) {
    const auto source = std::make_shared<Frames>();
    const auto add = [&](auto frame) {
        std::vector<float> heights;
        for (int z = 0; z < texels.y; ++z)
            for (int x = 0; x < texels.x; ++x) {
                const glm::dvec2 at = center + size * ((glm::dvec2(x, z) + 0.5) / glm::dvec2(texels) - 0.5);
                heights.push_back(float(frame(at.x, at.y)));
            }
        source->fields.push_back(
            std::make_shared<HeightField>(makeHeightField(texels, heights, glm::dvec2(texels) / 16.0)));
    };
    (add(f), ...);
    Wave wave;
    wave.type = WaveType::HeightMap;
    wave.amplitude = 1;
    wave.center = center;
    wave.size = size;
    wave.heights = source;
    return wave;
}

class HeightMapGLTest : public GLTest {
  protected:
    struct Surface {
        std::vector<glm::vec4> positions, normals;
        glm::dvec2 slope(std::size_t i) const {
            return {-normals[i].x / normals[i].y, -normals[i].z / normals[i].y};
        }
    };

    static Surface read(const WaterSurface& surface) {
        const auto count = std::size_t(surface.mesh().vertexCount);
        return {surface.mesh().positions.read<glm::vec4>(count),
                surface.mesh().normals.read<glm::vec4>(count)};
    }
    static Surface surfaceOf(const std::vector<Wave>& waves, const WaterPatch& patch, double time = 0,
                             const glm::dvec3& origin = {}) {
        Water water;
        water.waves = waves;
        WaterSurface surface(context());
        surface.update(water, patch, origin, time);
        return read(surface);
    }
};

TEST(FramesAt, runInALoop) {
    const auto expect = [](double time, int first, int second, double share) {
        const FramePair pair = framesAt(4, 10, time);
        EXPECT_EQ(pair.first, first) << time;
        EXPECT_EQ(pair.second, second) << time;
        EXPECT_NEAR(pair.share, share, 1e-6) << time;
    };
    expect(0, 0, 0, 0);
    expect(0.05, 0, 1, 0.5);
    expect(0.3, 3, 3, 0);
    expect(0.1 + 0.2, 3, 3, 0);
    expect(0.375, 3, 0, 0.75);
    expect(0.4, 0, 0, 0);
    expect(1e6 + 0.125, 1, 2, 0.25);
    expect(-0.05, 3, 0, 0.5);
    expect(-1e-12, 0, 0, 0);
    EXPECT_EQ(framesAt(1, 30, 0.01).second, 0);
    EXPECT_EQ(framesAt(1, 30, 0.01).share, 0);
}

TEST_F(HeightMapGLTest, followsTheImage) {
    // One pixel stands up: column 20 of 32, row 5 of 16. Seen from above, x is right and z down.
    const test::TempFolder folder;
    std::vector<float> pixels(32 * 16, 0.0f);
    pixels[5 * 32 + 20] = 3;
    io::writeExr(folder.path() / "h.exr", 32, 16, {"R"}, pixels);
    Wave wave;
    wave.type = WaveType::HeightMap;
    wave.amplitude = 0.01;
    wave.center = {7, -4};
    wave.size = {2, 1};
    wave.heights = io::openHeightImages(folder.path() / "h.exr", {0, 0});
    // A vertex in the middle of every pixel, but for the two outermost, where the surface runs out.
    const Surface surface = surfaceOf({wave}, {{7, -4}, {2 - 5.0 / 16, 1 - 5.0 / 16}, {27, 11}});
    constexpr std::size_t standing = (5 - 2) * 28 + 20 - 2;
    for (std::size_t i = 0; i < surface.positions.size(); ++i)
        EXPECT_NEAR(surface.positions[i].y, i == standing ? 0.03f : 0.0f, 1e-6f) << i;
    EXPECT_NEAR(surface.positions[standing].x, 7 - 1 + 20.5 / 16, 1e-5);
    EXPECT_NEAR(surface.positions[standing].z, -4 - 0.5 + 5.5 / 16, 1e-5);
}

TEST_F(HeightMapGLTest, aCosineImageIsTheCosineWave) {
    constexpr double amplitude = 0.02, wavelength = 0.5, k = 2 * std::numbers::pi / wavelength;
    constexpr double h = 4.0 / 128; // m, 16 texels a wave
    const Wave wave = scenes::cosine(amplitude, wavelength, {1, 0});
    const Wave image = heightMap({128, 128}, {0.1, 0.2}, {4, 4},
                                 [](double x, double) { return amplitude * std::cos(k * x); });
    // Clear of the fade of 0.25 m and 20 texels more: what the spline does at the edge decays by 0.27 a
    // texel.
    const WaterPatch patch{{0.1, 0.2}, glm::dvec2(4 - 2 * (0.25 + 20 * h)), {150, 150}};
    const Surface expected = surfaceOf({wave}, patch), found = surfaceOf({image}, patch);
    // Cubic spline interpolation (Hall and Meyer, "Optimal error bounds for cubic spline interpolation",
    // 1976): heights 5/384 h⁴ |f''''|, slopes 1/24 h³ |f''''|; and rounding in single precision.
    const double fourth = amplitude * std::pow(k, 4);
    const double heightBound = 5.0 / 384 * std::pow(h, 4) * fourth + 1e-7;
    const double slopeBound = 1.0 / 24 * std::pow(h, 3) * fourth + 1e-5;
    double height = 0, slope = 0;
    for (std::size_t i = 0; i < expected.positions.size(); ++i) {
        height = std::max(height, double(std::abs(expected.positions[i].y - found.positions[i].y)));
        slope = std::max(slope, glm::length(expected.slope(i) - found.slope(i)));
    }
    EXPECT_LT(height, heightBound);
    EXPECT_LT(slope, slopeBound);
    printf("height within %.2g m of %.2g allowed, slope within %.2g of %.2g\n", height, heightBound, slope,
           slopeBound);
}

TEST_F(HeightMapGLTest, slopesAreTheDerivativesOfTheHeight) {
    const Wave image = heightMap({24, 40}, {0.3, -0.2}, {1.5, 2}, [](double x, double z) {
        return 0.05 * std::sin(5 * x + 3 * z) + 0.03 * std::cos(11 * x * z) + (x > 0.4 ? 0.02 : 0.0);
    });
    // Off the image on all sides; a quad is about a tenth of a texel.
    const glm::ivec2 quads(300, 450);
    const WaterPatch patch{{0.3, -0.2}, {1.8, 2.3}, quads};
    const Surface surface = surfaceOf({image}, patch);
    const glm::dvec2 step = patch.size / glm::dvec2(quads);
    const glm::dvec2 texel = image.size / glm::dvec2(24, 40);
    // A central difference is off by step²/6 of the third derivative. That is piecewise constant, at most
    // 8 of the largest coefficient over texel³; 1e-8 m of rounding over two steps adds 1e-6.
    const glm::dvec2 bound =
        step * step / 6.0 * 8.0 * image.heights->bounds().highest / (texel * texel * texel) + 2e-5;
    double largest = 0;
    Water water;
    water.waves = {image};
    for (int z = 1; z < quads.y; ++z)
        for (int x = 1; x < quads.x; ++x) {
            const auto at = [&](int i, int j) { return std::size_t(j * (quads.x + 1) + i); };
            const auto y = [&](int i, int j) { return double(surface.positions[at(i, j)].y); };
            const glm::dvec2 slope = surface.slope(at(x, z));
            EXPECT_NEAR(slope.x, (y(x + 1, z) - y(x - 1, z)) / (2 * step.x), bound.x);
            EXPECT_NEAR(slope.y, (y(x, z + 1) - y(x, z - 1)) / (2 * step.y), bound.y);
            EXPECT_LE(std::abs(y(x, z)), highestWave(water) + 1e-6);
            largest = std::max(largest, glm::length(slope));
        }
    EXPECT_LE(largest, steepestSlope(water)) << "the bound holds";
    EXPECT_GT(largest, 0.3 * steepestSlope(water)) << "and is not idle";
    printf("steepest %.3g of %.3g, differences within %.2g, %.2g\n", largest, steepestSlope(water), bound.x,
           bound.y);
}

TEST_F(HeightMapGLTest, isFlatOutsideOfItsPlacement) {
    const Wave image = heightMap({16, 16}, {0, 0}, {1, 1}, [](double, double) { return 0.1; });
    const WaterPatch patch{{0, 0}, {4, 4}, {80, 80}};
    const Surface surface = surfaceOf({image}, patch);
    for (std::size_t i = 0; i < surface.positions.size(); ++i) {
        const glm::vec4 p = surface.positions[i];
        if (std::max(std::abs(p.x), std::abs(p.z)) >= 0.5f) {
            EXPECT_EQ(p.y, 0) << p.x << ' ' << p.z;
            EXPECT_EQ(surface.normals[i].y, 1);
        }
    }
    EXPECT_NEAR(surface.positions[40 * 81 + 40].y, 0.1f, 1e-4f);
}

TEST_F(HeightMapGLTest, sequencesAreInterpolatedAndLoadedOnce) {
    const auto level = [](double height) { return [=](double, double) { return height; }; };
    Wave image = heightMap({64, 64}, {0, 0}, {1, 1}, level(0.1), level(0.3), level(-0.2));
    image.fps = 10;
    image.amplitude = 2;
    Water water;
    water.waves = {image};
    WaterSurface surface(context());
    const std::int64_t before = context().ledger().bytes("height map");
    const auto heightAt = [&](double time) {
        surface.update(water, {{0, 0}, {0.1, 0.1}, {1, 1}}, {}, time);
        return double(read(surface).positions.front().y);
    };
    auto& source = static_cast<Frames&>(*image.heights);
    EXPECT_NEAR(heightAt(0), 2 * 0.1, 1e-5);
    EXPECT_EQ(source.asked, 1) << "a whole frame needs no other";
    EXPECT_EQ(context().ledger().bytes("height map") - before, 64 * 64 * 4);
    EXPECT_NEAR(heightAt(0.025), 2 * (0.75 * 0.1 + 0.25 * 0.3), 1e-5);
    EXPECT_NEAR(heightAt(0.05), 2 * 0.2, 1e-5);
    EXPECT_EQ(source.asked, 2);
    EXPECT_NEAR(heightAt(0.15), 2 * 0.05, 1e-5);
    EXPECT_EQ(source.asked, 3) << "frame 1 is there";
    EXPECT_NEAR(heightAt(0.25), 2 * -0.05, 1e-5) << "from the last frame to the first";
    EXPECT_EQ(source.asked, 4);
    EXPECT_NEAR(heightAt(0.35), 2 * 0.2, 1e-5) << "and round";
    EXPECT_EQ(context().ledger().bytes("height map") - before, 2 * 64 * 64 * 4);
    water.waves.clear();
    EXPECT_EQ(heightAt(0), 0);
    EXPECT_EQ(context().ledger().bytes("height map"), before) << "given back with the waves";
}

TEST_F(HeightMapGLTest, addsUpWithOtherWavesAnywhere) {
    const auto bump = [](double x, double z) { return 0.1 * std::exp(-20 * (x * x + z * z)); };
    const std::vector<Wave> waves = {heightMap({64, 32}, {0, 0}, {2, 2}, bump), scenes::noise(0.03, 0.4),
                                     heightMap({32, 32}, {0.2, 0.1}, {1, 1}, bump, bump),
                                     heightMap({32, 64}, {0, 0.3}, {1, 2}, bump),
                                     heightMap({16, 16}, {-0.1, 0.1}, {3, 3}, bump)};
    const WaterPatch patch{{0.1, -0.2}, {3, 2}, {24, 16}};
    std::vector<glm::vec3> sum(25 * 17, glm::vec3(0));
    for (const Wave& wave : waves) {
        const Surface alone = surfaceOf({wave}, patch, 0.01);
        for (std::size_t i = 0; i < sum.size(); ++i)
            sum[i] += glm::vec3(alone.positions[i].y, alone.slope(i));
    }
    const Surface all = surfaceOf(waves, patch, 0.01, {0, 0.5, 0});
    for (std::size_t i = 0; i < sum.size(); ++i) {
        EXPECT_NEAR(all.positions[i].y, sum[i].x - 0.5f, 1e-6f);
        EXPECT_NEAR(all.slope(i).x, double(sum[i].y), 3e-6);
        EXPECT_NEAR(all.slope(i).y, double(sum[i].z), 3e-6);
    }
}

TEST_F(HeightMapGLTest, staysSharpFarFromTheWorldsOrigin) {
    const auto wave = [](double x, double z) { return 0.02 * std::sin(9 * x + 5 * z); };
    const glm::dvec3 far(1e6, 0, -2e6);
    const Wave near = heightMap({64, 64}, {0.1, 0.2}, {1, 1}, wave);
    Wave moved = near;
    moved.center += glm::dvec2(far.x, far.z);
    WaterPatch patch{{0.1, 0.2}, {1, 1}, {20, 20}};
    const Surface here = surfaceOf({near}, patch);
    patch.center += glm::dvec2(far.x, far.z);
    const Surface there = surfaceOf({moved}, patch, 0, far);
    for (std::size_t i = 0; i < here.positions.size(); ++i)
        EXPECT_NEAR(here.positions[i].y, there.positions[i].y, 1e-6f);
}

TEST_F(HeightMapGLTest, moreThanFourAreAnError) {
    const std::vector<Wave> waves(5, heightMap({8, 8}, {0, 0}, {1, 1}, [](double, double) { return 0.1; }));
    EXPECT_THROW(surfaceOf(waves, {{0, 0}, {1, 1}, {1, 1}}), InputError);
}

} // namespace
} // namespace limpid
