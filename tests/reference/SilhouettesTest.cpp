// Texels that a receiver's own parts share.
#include <gtest/gtest.h>

#include "reference/Traced.h"

namespace limpid {
namespace {

/// A floor with something on it, one receiver, under a point light: its light leans outwards from how the map
/// looks, by 0.15 at x = 0.5.
class SilhouettesTest : public testing::Test {
  protected:
    static test::Traced traceWith(const Mesh* thing, const glm::dvec3& at) {
        Mesh mesh = makePlane({2, 2}, glm::vec3(0.8f));
        if (thing) scenes::join(mesh, *thing, at);
        Scene scene;
        scene.receivers = {scenes::shape("floor", std::move(mesh), {0, -1, 0})};
        Light pointLight;
        pointLight.type = LightType::Point;
        pointLight.position = {0, 2, 0};
        scene.lights = {pointLight};
        scene.caustics.mapSize = 128;
        return test::trace(scene, 1'000'000);
    }

    /// The light on the floor's texels whose middle is at x in [from, to] and z in [-0.1, 0.1], over what it
    /// is with nothing there: the least and the most.
    static glm::dvec2 extremes(const test::Traced& found, const test::Traced& free, double from, double to) {
        glm::dvec2 range(1e30, -1e30);
        for (int y = 0; y < found.size().y; ++y)
            for (int x = 0; x < found.size().x; ++x) {
                const glm::dvec3 p = found.position(0, x, y);
                if (p.x < from || p.x > to || std::abs(p.z) > 0.1 || p.y > -0.999) continue;
                const double share = found.irradiance(0, x, y) / free.irradiance(0, x, y);
                range = {std::min(range.x, share), std::max(range.y, share)};
            }
        return range;
    }
};

TEST_F(SilhouettesTest, whatIsHiddenFromTheMapIsNotInIt) {
    // A lid over x in [0.51, 0.71], 0.4 m up: light reaches 6 cm of the floor below it, of which the map sees
    // nothing. The lid covers a third of the texel from 0.5 to 0.516.
    const Mesh lid = makePlane({0.2, 0.6}, glm::vec3(0.8f));
    const test::Traced found = traceWith(&lid, {0.61, 0.4, 0}), free = traceWith(nullptr, {});
    ASSERT_EQ(found.size(), free.size());
    const glm::dvec2 before = extremes(found, free, 0.4, 0.51);
    // Where cells straddle the edge, 1,000 plain photons a texel are noise.
    EXPECT_NEAR(before.x, 1, 0.05);
    EXPECT_NEAR(before.y, 1, 0.05);
    const glm::dvec2 shade = extremes(found, free, 0.72, 0.75);
    EXPECT_LT(shade.y, 0.01) << "the lid's shade is where the lamp throws it";
}

TEST_F(SilhouettesTest, aWallsLightIsNotTheFloors) {
    // A wall of 0.3 m that leans by 6 mm takes as much light as 5 cm of floor, and the map sees it in a third
    // of one texel.
    Mesh wall = makeBox({0.001, 0.3, 0.3}, glm::vec3(0.8f));
    for (glm::dvec3& p : wall.positions)
        p.x += 0.02 * p.y;
    const test::Traced found = traceWith(&wall, {0.512, 0.15, 0}), free = traceWith(nullptr, {});
    ASSERT_EQ(found.size(), free.size());
    const glm::dvec2 before = extremes(found, free, 0.4, 0.508);
    EXPECT_NEAR(before.x, 1, 0.05);
    EXPECT_NEAR(before.y, 1, 0.05);
    EXPECT_GT(found.light().rejected, 0.02 * 0.3 * free.irradiance(0, 96, 64)) << "it has no texel";
}

} // namespace
} // namespace limpid
