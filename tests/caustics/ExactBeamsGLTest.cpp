#include <cmath>

#include "caustics/CosineTruth.h"
#include "caustics/ExactBeams.h"
#include "engine/EngineFixture.h"

namespace limpid {
namespace {

class ExactBeamsGLTest : public EngineGLTest {
  protected:
    static Scene floorPastSphere() {
        Scene scene = scenes::floorPastSphere(30);
        scene.water.grid = {128, 128};
        scene.caustics.mapSize = 384;
        scene.caustics.method = Method::ExactBeam;
        return scene;
    }
};

struct CosineError {
    double nmae, fluxRatio;
};

/// Of exact beams on a floor of 512 texels a metre, against the texel means in double precision.
CosineError cosineError(const Baked& baked) {
    const auto truth = CosineTruth{}.texels(-0.5, 512, 512);
    const MapData& map = baked.maps.at(0);
    double error = 0, sum = 0, whole = 0;
    for (int y = 0; y < 512; ++y)
        for (int x = 0; x < 512; ++x) {
            const double value = map.irradiance[3 * (std::size_t(y) * 512 + std::size_t(x))];
            error += std::abs(value - truth[std::size_t(x)]);
            sum += value;
            whole += truth[std::size_t(x)];
        }
    return {error / whole, sum / whole};
}

TEST_F(ExactBeamsGLTest, convergesToOneCosineWave) {
    // The bars of the method: a finer grid must bring the map to the truth, which no centre-sampled map does.
    const struct {
        int grid;
        double nmae;
    } bars[] = {{256, 0.015}, {512, 0.0035}, {1024, 0.001}};
    for (const auto& bar : bars) {
        Scene scene;
        scene.receivers = {scenes::floorAt(-1, 1)};
        scene.lights = {scenes::sunAt(0)};
        scene.water.waves = {scenes::cosine(0.004, 0.2, {1, 0})};
        scene.water.center = glm::dvec2(0);
        scene.water.size = glm::dvec2(1.09);
        scene.water.grid = glm::ivec2(bar.grid);
        scene.caustics.mapSize = 512;
        scene.caustics.method = Method::ExactBeam;
        const Baked baked = bake(scene);
        ASSERT_EQ(baked.maps.at(0).size, glm::ivec2(512));
        const CosineError error = cosineError(baked);
        printf("%d quads: nMAE %.3f %%, flux ratio %.5f\n", bar.grid, 100 * error.nmae, error.fluxRatio);
        EXPECT_LE(error.nmae, bar.nmae) << bar.grid;
        EXPECT_NEAR(error.fluxRatio, 1, 0.001) << bar.grid;
    }
}

TEST_F(ExactBeamsGLTest, everyRunGivesTheSameBits) {
    Scene scene = floorPastSphere();
    scene.water.waves = {scenes::cosine(0.01, 0.3, {1, 0.4}), scenes::noise(0.01, 0.5)};
    const Baked a = bakeAfresh(scene), b = bakeAfresh(scene);
    ASSERT_EQ(a.maps.size(), 2u);
    for (std::size_t i = 0; i < a.maps.size(); ++i)
        EXPECT_EQ(a.maps[i].irradiance, b.maps[i].irradiance);
}

TEST_F(ExactBeamsGLTest, lightAlongFlanksIsTheSameInEveryRun) {
    // Its flanks have maps of their own, which light crosses from end to end: hundreds of texels a quad.
    Scene scene;
    scene.receivers = {scenes::model("fish", -1)};
    scene.lights = {scenes::sunAt(20)};
    scene.water.waves = {scenes::cosine(0.012, 0.5, {1, 0.3}), scenes::noise(0.02, 0.45)};
    scene.water.grid = {96, 96};
    scene.caustics.mapSize = 384;
    scene.caustics.method = Method::ExactBeam;
    const Baked a = bakeAfresh(scene, true), b = bakeAfresh(scene);
    ASSERT_GT(a.maps.size(), 1u) << "flanks";
    for (std::size_t i = 0; i < a.maps.size(); ++i)
        EXPECT_EQ(a.maps[i].irradiance, b.maps[i].irradiance);
    const FluxBalance& flux = a.flux.at(0);
    printf("residual %.3f %% of entering\n", 100 * flux.residual() / flux.entering);
    EXPECT_LT(std::abs(flux.residual()), 0.002 * flux.entering);
}

TEST_F(ExactBeamsGLTest, flanksOfAnyMapSizeTakeTheirLight) {
    // Waves, sun and box are even about the middle: opposite flanks are lit alike, but for how the water is
    // cut into triangles. No side of these maps is a power of two.
    Scene scene;
    scene.receivers = {scenes::shape("block", makeBox({0.6, 0.5, 0.4}, glm::vec3(0.8f)), {0, -0.8, 0})};
    scene.lights = {scenes::sunAt(0)};
    scene.water.waves = {scenes::cosine(0.012, 0.4, {1, 0.3}), scenes::cosine(0.01, 0.3, {-0.4, 1})};
    scene.water.grid = {96, 96};
    for (const Method method : {Method::ExactBeam, Method::LevelMap}) {
        scene.caustics.method = method;
        scene.caustics.mapSize = 120;
        const Baked baked = bake(scene);
        ASSERT_EQ(baked.maps.size(), 5u) << "one from above, four flanks";
        EXPECT_GT(baked.maps[2].deposited, 0);
        EXPECT_NEAR(baked.maps[4].deposited / baked.maps[2].deposited, 1, 0.05) << methodName(method);
    }
}

TEST_F(ExactBeamsGLTest, aFewLargeBeamsLightAsManySmall) {
    // Flat water, so that nothing but the way of depositing differs: 18 beams of tens of thousands of texels
    // are shared out among many invocations, 73,728 small ones are not.
    for (const bool sphere : {false, true}) {
        Scene scene = floorPastSphere();
        if (!sphere) scene.receivers.pop_back();
        scene.water.absorption = {0.4, 0.2, 0.1};
        scene.water.center = glm::dvec2(0);
        scene.water.size = glm::dvec2(6);
        scene.water.grid = {3, 3};
        const MapData few = bake(scene).maps.at(0);
        scene.water.grid = {192, 192};
        const MapData many = bake(scene).maps.at(0);
        double error = 0, sum = 0;
        for (std::size_t i = 0; i < few.irradiance.size(); ++i) {
            error += std::abs(double(few.irradiance[i]) - double(many.irradiance[i]));
            sum += many.irradiance[i];
        }
        // At the edge of shade a texel's part of a large beam is lit or not as one; small beams share it.
        EXPECT_LT(error / sum, sphere ? 0.002 : 1e-4) << sphere;
        EXPECT_GT(sum, 0);
    }
}

/// Beams of all kinds beside something that shades them: narrow ones, broad ones, and some along the
/// receiver.
Scene sphereInWaves(int grid) {
    Scene scene = scenes::floorPastSphere(30);
    scene.water.waves = {scenes::cosine(0.01, 0.3, {1, 0.4})};
    scene.water.absorption = {0.4, 0.2, 0.1};
    scene.water.grid = glm::ivec2(grid);
    scene.caustics.mapSize = 192;
    scene.caustics.method = Method::ExactBeam;
    return scene;
}

TEST_F(ExactBeamsGLTest, touchesWithoutRoomGiveTheSameBits) {
    for (const int grid : {12, 48, 192}) {
        Engine engine(context());
        engine.set(sphereInWaves(grid));
        engine.updateCaustics(0);
        const Scene& scene = engine.scene();
        const Occluders occluders(context(), scene.receivers, engine.origin());
        for (const std::int64_t room : {1, 4096}) {
            ExactBeams cramped(context(), room);
            for (const MapWork& map : engine.maps()) {
                CausticMap caustics;
                cramped.fill(caustics,
                             {map.level, map.plan.receiver, map.tangents, &occluders,
                              engine.light(map.plan.light).beams, engine.waterMesh(), engine.waterPatch(),
                              scene.water, scene.lights[std::size_t(map.plan.light)]});
                EXPECT_EQ(caustics.irradiance.readFloats(GL_RGBA, 4),
                          map.caustics.irradiance.readFloats(GL_RGBA, 4))
                    << grid << " quads a side, map of receiver " << map.plan.receiver << ", room for "
                    << room;
            }
        }
    }
}

TEST_F(ExactBeamsGLTest, lightBalancesUnderWaves) {
    Scene scene = floorPastSphere();
    scene.water.waves = {scenes::cosine(0.01, 0.3, {1, 0.4}), scenes::noise(0.01, 0.5)};
    const FluxBalance flux = bake(scene, true).flux.at(0);
    printf("residual %.3f %%, rejected %.3f %%\n", 100 * flux.residual() / flux.entering,
           100 * flux.rejected / flux.entering);
    EXPECT_LT(std::abs(flux.residual()), 0.002 * flux.entering);
    EXPECT_LT(std::abs(flux.rejected), 0.002 * flux.entering);
}

/// A plate 1.1 m over a floor, the sun straight above flat water.
Scene plateOverFloor(const glm::dvec3& place, double turn) {
    Scene scene;
    scene.receivers = {scenes::floorAt(-2), scenes::floorAt(0, 0.8)};
    scene.receivers[1].name = "plate";
    scene.receivers[1].translation = place;
    scene.receivers[1].rotation = glm::angleAxis(turn, glm::dvec3(0, 1, 0));
    scene.lights = {scenes::sunAt(0)};
    scene.water.grid = {128, 128};
    scene.caustics.mapSize = 256;
    scene.caustics.method = Method::ExactBeam;
    return scene;
}

TEST_F(ExactBeamsGLTest, aSunsDiscGivesHalfShadows) {
    // The plate's left edge is above the floor's middle.
    Scene scene = plateOverFloor({0.4, -0.9, 0}, 0);
    const double hard = bake(scene).maps[0].irradiance[0];
    scene.lights[0].angularDiameter = 4;
    const MapData soft = bake(scene).maps[0];
    const auto share = [&](int x) {
        return soft.irradiance[3 * (std::size_t(soft.size.y / 2 * soft.size.x) + std::size_t(x))] / hard;
    };
    // How far the rim's light comes aside from the surface to the floor, texels.
    const int radius = int(128 * 2 * std::tan(glm::radians(2.0)) / scene.water.ior);
    const int edge = soft.size.x / 2;
    EXPECT_NEAR(share(edge - radius - 2), 1, 0.002) << "beyond the penumbra";
    // One of four points may lie on the edge, and counts on either side of it.
    EXPECT_NEAR(0.5 * (share(edge - 1) + share(edge)), 0.5, 0.125) << "half of the disc is hidden";
    EXPECT_NEAR(share(edge + radius + 2), 0, 0.002) << "in full shadow";
    for (int x = edge - radius - 2; x < edge + radius + 2; ++x)
        EXPECT_GE(share(x), share(x + 1) - 0.002) << "at texel " << x;
}

TEST_F(ExactBeamsGLTest, halfShadowsTakeAndGiveTheSameLight) {
    Scene scene = plateOverFloor({0.13, -0.9, 0.07}, 0.3);
    const double hard = bake(scene).maps[0].deposited;
    scene.lights[0].angularDiameter = 4;
    EXPECT_NEAR(bake(scene).maps[0].deposited / hard, 1, 0.002);
}

TEST_F(ExactBeamsGLTest, aSeamLeftOpenLetsNoLightThrough) {
    Scene scene = floorPastSphere();
    scene.water.waves = {scenes::cosine(0.02, 0.3, {1, 0.4})};
    const auto whole = bake(scene).maps.at(0).irradiance;
    Mesh mesh = *scene.receivers[1].mesh;
    // Its lowest triangle lies in its own shade.
    const auto height = [&](std::size_t t) { return mesh.positions[mesh.indices[3 * t]].y; };
    std::size_t lowest = 0;
    for (std::size_t t = 1; t < mesh.triangleCount(); ++t)
        if (height(t) < height(lowest)) lowest = t;
    mesh.indices.erase(mesh.indices.begin() + std::ptrdiff_t(3 * lowest),
                       mesh.indices.begin() + std::ptrdiff_t(3 * lowest + 3));
    mesh.parts[0].indexCount -= 3;
    scene.receivers[1].mesh = std::make_shared<const Mesh>(std::move(mesh));
    const auto open = bake(scene).maps.at(0).irradiance;
    ASSERT_EQ(open.size(), whole.size());
    double sum = 0, more = 0;
    for (std::size_t i = 0; i < whole.size(); ++i) {
        sum += whole[i];
        more += std::abs(open[i] - whole[i]);
    }
    // The light that may get in where the triangle was: its share of the sphere's disc, times the disc's of
    // the floor, is below 1e-5.
    EXPECT_LT(more, 1e-5 * sum);
}

TEST_F(ExactBeamsGLTest, restingWaterCostsNothing) {
    Engine& engine = sharedEngine();
    Scene scene = floorPastSphere();
    scene.water.waves = {scenes::cosine(0.01, 0.3, {1, 0.4})};
    engine.set(scene);
    engine.updateCaustics(0);
    const auto first = readMaps(engine.maps()[0], engine.origin()).irradiance;
    engine.timers().collect();
    engine.updateCaustics(1); // the wave stands still
    EXPECT_TRUE(engine.timers().collect().empty());

    scene.water.waves[0].speed = 0.5;
    engine.set(scene);
    engine.updateCaustics(0);
    engine.timers().collect();
    engine.updateCaustics(1);
    for (const auto& [pass, milliseconds] : engine.timers().collect())
        EXPECT_TRUE(pass == "water" || pass == "beams" || pass == "caustic map") << pass;
    EXPECT_NE(readMaps(engine.maps()[0], engine.origin()).irradiance, first);

    // All work done anew gives what reuse gave.
    const auto reused = readMaps(engine.maps()[0], engine.origin()).irradiance;
    engine.setSkipping(false);
    engine.updateCaustics(1);
    EXPECT_EQ(readMaps(engine.maps()[0], engine.origin()).irradiance, reused);
}

} // namespace
} // namespace limpid
