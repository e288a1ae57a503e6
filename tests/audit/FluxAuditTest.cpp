// Rays counted on the CPU against closed forms: no GPU, and beams that are known.
#include "audit/FluxAudit.h"

#include <cmath>

#include <gtest/gtest.h>

#include "engine/Scenes.h"

namespace limpid {
namespace {

// A place stands for its number: each quarter of [0, 1), and each quarter of that, is a piece of a quarter of
// the area.
TEST(FluxAuditTest, placesFillATriangleEvenly) {
    constexpr int count = 4096;
    glm::dvec3 sum(0);
    int inHalf = 0;
    for (int i = 0; i < count; ++i) {
        const glm::dvec3 place = trianglePlace((i + 0.5) / count);
        EXPECT_NEAR(place.x + place.y + place.z, 1, 1e-12);
        EXPECT_GE(std::min({place.x, place.y, place.z}), 0);
        sum += place / double(count);
        inHalf += place.x > 0.5 ? 1 : 0; // a triangle of half the side
    }
    EXPECT_EQ(inHalf, count / 4);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(sum[c], 1.0 / 3, 1e-3);
}

/// Flat water of 2 x 2 m in `cells`² quads, light straight down, all of it let in.
BeamRays upright(int cells) {
    BeamRays::Data beams;
    for (int z = 0; z <= cells; ++z)
        for (int x = 0; x <= cells; ++x) {
            beams.origins.emplace_back(2.0 * x / cells - 1, 0, 2.0 * z / cells - 1, 1);
            beams.directions.emplace_back(0, -1, 0, 0);
        }
    for (int z = 0; z < cells; ++z)
        for (int x = 0; x < cells; ++x) {
            const std::uint32_t a = std::uint32_t(z * (cells + 1) + x), c = a + std::uint32_t(cells) + 1;
            beams.indices.insert(beams.indices.end(), {a, c, a + 1, a + 1, c, c + 1});
        }
    beams.flux.assign(std::size_t(2 * cells * cells), float(2.0 / (cells * cells)));
    beams.lit.assign(beams.flux.size(), 1);
    return BeamRays(std::move(beams));
}

/// A disc-like ball of radius `radius` in the middle of that light.
Scene ballScene(double radius) {
    Scene scene;
    scene.receivers = {scenes::shape("ball", makeSphere(radius, glm::vec3(0.8f), 256), {0.1, -1, 0.05})};
    scene.lights = {scenes::sunAt(0)};
    return scene;
}

// Few quads and many: the count is right within a few of its own standard errors, and these are what was
// asked for.
TEST(FluxAuditTest, missedIsWhatABallLeaves) {
    const Scene scene = ballScene(0.5);
    const FluxAudit audit(scene, glm::dvec3(0));
    for (const int cells : {1, 8, 64, 400}) {
        const FluxBalance flux = audit.count(upright(cells), 0, {});
        EXPECT_NEAR(flux.entering, 4, 1e-5);
        // The ball's outline is a polygon of 256 corners.
        const double disc = 128 * std::sin(2 * M_PI / 256) * 0.25;
        EXPECT_NEAR(flux.missed, 4 - disc, 4 * flux.standardError + 2e-4) << cells;
        EXPECT_LE(flux.standardError, 1.3 * FluxAudit::wantedError * flux.entering) << cells;
        EXPECT_NEAR(flux.missed + flux.rejected, flux.entering, 1e-9);
        EXPECT_GT(flux.standardError, 0) << cells;
        printf("%d quads: %lld rays, missed off by %.2f standard errors\n", cells, (long long)flux.rays,
               (flux.missed - 4 + disc) / flux.standardError);
    }
}

TEST(FluxAuditTest, theSameBeamsGiveTheSameBits) {
    const Scene scene = ballScene(0.3);
    const FluxBalance a = FluxAudit(scene, glm::dvec3(0)).count(upright(32), 0, {});
    const FluxBalance b = FluxAudit(scene, glm::dvec3(0)).count(upright(32), 0, {});
    EXPECT_EQ(a.missed, b.missed);
    EXPECT_EQ(a.rejected, b.rejected);
    EXPECT_EQ(a.standardError, b.standardError);
}

// All land, 1 m down: Beer and Lambert's law, shared out by what took it, without any chance.
TEST(FluxAuditTest, waterTakesByItsLaw) {
    Scene scene;
    scene.receivers = {scenes::shape("floor", makePlane({2.2, 2.2}, glm::vec3(0.8f)), {0, -1, 0})};
    scene.lights = {scenes::sunAt(0)};
    scene.water.absorption = glm::dvec3(0.3);
    scene.water.scattering = glm::dvec3(0.1);
    const FluxBalance flux = FluxAudit(scene, glm::dvec3(0)).count(upright(16), 0, {});
    const double gone = 4 * (1 - std::exp(-0.4));
    EXPECT_NEAR(flux.absorbed, 0.75 * gone, 1e-5);
    EXPECT_NEAR(flux.scattered, 0.25 * gone, 1e-5);
    EXPECT_EQ(flux.missed, 0);
    EXPECT_LT(flux.standardError, 1e-6);
}

/// A map of 4 x 4 texels, seen from above, of a floor of 1 x 1 m whose right half is 0.2 m lower.
struct StepMap {
    Scene scene;
    std::vector<float> position, normal, coverage;

    StepMap() {
        scene.receivers = {scenes::shape("step", makeStep(), {0, 0, 0})};
        for (int i = 0; i < 16; ++i) {
            const float x = (float(i % 4) + 0.5f) / 4, z = (float(i / 4) + 0.5f) / 4;
            position.insert(position.end(), {x, x < 0.6f ? -1.0f : -1.2f, z, 1});
            normal.insert(normal.end(), {0, 1, 0});
            coverage.push_back(i % 4 == 2 ? 0.6f : 1); // the step is at 0.6
        }
    }
    static Mesh makeStep() {
        Mesh mesh;
        for (const double x : {0.0, 0.6})
            mesh.positions.insert(mesh.positions.end(), {{x, x > 0 ? -1.2 : -1, 0},
                                                         {x, x > 0 ? -1.2 : -1, 1},
                                                         {x > 0 ? 1 : 0.6, x > 0 ? -1.2 : -1, 1},
                                                         {x > 0 ? 1 : 0.6, x > 0 ? -1.2 : -1, 0}});
        mesh.normals.assign(8, {0, 1, 0});
        mesh.uvs.assign(8, {0, 0});
        mesh.indices = {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7};
        mesh.parts = {MeshPart{0, 12, 0}};
        mesh.materials = {Material{}};
        return mesh;
    }
    ShownSurface shown() const {
        ShownSurface map;
        map.faces = {{0, -1, 0}, 0.07, {}, {}, false};
        map.frame.box = {{0, -0.9, 0}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {1, 1, 0.4}};
        map.frame.size = {4, 4};
        map.frame.texel = 0.25;
        map.position = position, map.normal = normal, map.coverage = coverage;
        return map;
    }
};

// A texel whose middle is on the upper floor has none of the light that lands beside it on the lower one.
TEST(FluxAuditTest, aTexelTakesWhatLandsOnTheFaceAtItsMiddle) {
    const StepMap step;
    const reference::SceneGeometry geometry(step.scene, glm::dvec3(0));
    const ShownSurface map = step.shown();
    const auto share = [&](double x, double z) {
        return map.share(geometry.first({x, -0.5, z}, {0, -1, 0}), geometry);
    };
    EXPECT_EQ(share(0.1, 0.3), 1);
    EXPECT_EQ(share(0.51, 0.3), 0); // its texel's middle is at 0.625, on the lower floor
    EXPECT_EQ(share(0.7, 0.3), 1);
    EXPECT_EQ(share(0.9, 0.9), 1);
    ShownSurface dark = map;
    dark.taken.assign(16, 0.25f);
    EXPECT_EQ(dark.share(geometry.first({0.1, -0.5, 0.3}, {0, -1, 0}), geometry), 0.25);
    std::vector<float> unseen = step.position;
    unseen[3] = 0;
    ShownSurface hole = map;
    hole.position = unseen;
    EXPECT_EQ(hole.share(geometry.first({0.1, -0.5, 0.1}, {0, -1, 0}), geometry), 0);
}

} // namespace
} // namespace limpid
