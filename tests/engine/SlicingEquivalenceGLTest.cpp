#include "core/ImageErrors.h"
#include "engine/EngineFixture.h"

namespace limpid {
namespace {

/// Smart slicing in its automatic form may only leave out work: every texel keeps its bits.
class SlicingEquivalenceGLTest : public EngineGLTest, public ::testing::WithParamInterface<const char*> {};

TEST_P(SlicingEquivalenceGLTest, isBitIdenticalToAllPlanes) {
    Scene scene;
    scene.receivers = {scenes::model(GetParam(), -1.5)};
    scene.lights = {scenes::sunAt(0, "noon"), scenes::sunAt(-40, "evening")};
    scene.water.grid = {64, 64};
    scene.caustics.mapSize = 128;
    Engine& engine = sharedEngine();
    for (const bool rough : {false, true}) {
        scene.water.waves = {scenes::cosine(0.003, 0.4, {1, 0.3})};
        if (rough) scene.water.waves.push_back(scenes::noise(0.02, 0.3));
        for (const int planes : {3, 4, 17, 50}) {
            scene.caustics.planes = planes;
            // In one pass, empty planes take no time: even numbers of them see to it that none takes light.
            scene.caustics.fill = planes % 2 == 0 ? Fill::OnePass : Fill::Drawn;
            scene.caustics.method = Method::LevelMap;
            const Baked all = bake(engine, scene);
            scene.caustics.method = Method::LevelMapSmart;
            const Baked smart = bake(engine, scene);
            double sum = 0;
            for (std::size_t i = 0; i < all.maps.size(); ++i) {
                EXPECT_EQ(all.maps[i].irradiance, smart.maps[i].irradiance)
                    << planes << " planes, rough " << rough;
                EXPECT_EQ(luvDifference(all.maps[i].irradiance, smart.maps[i].irradiance,
                                        all.maps[i].normalDotAxis),
                          0);
                EXPECT_LE(smart.planesDrawn[i], all.planesDrawn[i]);
                EXPECT_EQ(all.planesDrawn[i], planes);
                sum += all.maps[i].deposited;
            }
            EXPECT_GT(sum, 0.1) << "there is light to compare";
        }
    }
}

INSTANTIATE_TEST_SUITE_P(models, SlicingEquivalenceGLTest,
                         ::testing::Values("teapot", "sphere", "box", "cross", "fish", "dolphin"),
                         [](const auto& model) { return std::string(model.param); });

} // namespace
} // namespace limpid
