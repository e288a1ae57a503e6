#include "caustics/Volumetric.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/Error.h"
#include "core/Optics.h"
#include "engine/EngineFixture.h"

namespace limpid {
namespace {

/// The upper half of a sphere: a height field, open at the bottom.
Mesh hemisphere(double radius) {
    Mesh mesh = makeSphere(radius, glm::vec3(0.8f));
    std::vector<std::uint32_t> kept;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto* corner = &mesh.indices[i];
        const double middle =
            (mesh.positions[corner[0]].y + mesh.positions[corner[1]].y + mesh.positions[corner[2]].y) / 3;
        if (middle > 0) kept.insert(kept.end(), corner, corner + 3);
    }
    mesh.indices = kept;
    mesh.parts = {{0, std::uint32_t(kept.size()), 0}};
    return mesh;
}

Receiver receiverNamed(const std::string& name) {
    if (name == "floor") return scenes::floorAt(-1);
    if (name == "hemisphere") return scenes::shape("hemisphere", hemisphere(0.5), {0, -1, 0});
    return scenes::model(name.c_str(), -1.5);
}

class VolumetricGLTest : public EngineGLTest {
  protected:
    static Scene sceneOf(const std::string& receiver, double degrees, int planes) {
        Scene scene;
        scene.receivers = {receiverNamed(receiver)};
        scene.lights = {scenes::sunAt(degrees)};
        scene.water.grid = {48, 48};
        scene.caustics.method = Method::Volumetric;
        scene.caustics.mapSize = 128;
        scene.caustics.planes = planes;
        return scene;
    }
    static void addWaves(Scene& scene) {
        scene.water.waves = {scenes::cosine(0.005, 0.4, {1, 0.3}), scenes::noise(0.01, 0.3)};
        scene.water.absorption = {0.4, 0.1, 0.05};
    }
    static Baked bakeLevelMap(Scene scene) {
        scene.caustics.method = Method::LevelMap;
        scene.caustics.fill = Fill::Drawn;
        return bake(scene);
    }

    /// What lies in the slices of a map: below the first surface of a column, and in all.
    struct Layers {
        int hidden = 0, seen = 0;            ///< texels
        double hiddenFlux = 0, seenFlux = 0; ///< W
        double hiddenPart() const { return double(hidden) / seen; }
        double hiddenFluxPart() const { return hiddenFlux / seenFlux; }
    };
    static Layers layersOf(const MapWork& maps) {
        const auto position = maps.slices.position.readFloats(GL_RG, 2);
        const auto normal = maps.slices.normal.readFloats(GL_RG, 2);
        const auto caustics = maps.slices.caustics.readFloats(GL_RGBA, 4);
        const TexelFrame& frame = maps.level.frame;
        const std::size_t texels = std::size_t(frame.size.x) * std::size_t(frame.size.y);
        std::vector<bool> taken(texels);
        Layers layers;
        for (std::size_t i = 0; i < position.size() / 2; ++i) {
            if (position[2 * i + 1] == -1) continue;
            const glm::vec3 n = shader::octahedralDecode({normal[2 * i], normal[2 * i + 1]});
            const double area =
                frame.texelArea() / std::max(std::abs(glm::dot(glm::dvec3(n), frame.box.t)), 4e-5);
            const double flux = double(caustics[4 * i]) * area;
            (taken[i % texels] ? layers.hidden : layers.seen) += 1;
            (taken[i % texels] ? layers.hiddenFlux : layers.seenFlux) += flux;
            taken[i % texels] = true;
        }
        return layers;
    }
};

/// Thesis 6.2: "per-pixel identical".
class VolumetricIdentityGLTest : public VolumetricGLTest, public ::testing::WithParamInterface<const char*> {
  protected:
    /// The same bits, but for texels in penumbra. There a sum is multiplied with the share of the light
    /// that arrives, where the level map multiplies each term: some hundred positive terms round to within 2
    /// · 100 · 2⁻²⁴ of each other. Returns the texels in penumbra.
    static int expectIdentity(const Scene& scene) {
        const double rounding = 1.2e-5;
        Engine& engine = sharedEngine();
        const Baked slices = bake(engine, scene), level = bakeLevelMap(scene);
        EXPECT_EQ(slices.planesDrawn, level.planesDrawn);
        int halfShade = 0;
        double deposited = 0;
        for (std::size_t i = 0; i < level.maps.size(); ++i) {
            EXPECT_EQ(slices.maps[i].position, level.maps[i].position);
            EXPECT_EQ(slices.maps[i].normal, level.maps[i].normal);
            deposited += level.maps[i].deposited;
            const auto diffuse = engine.maps()[i].level.diffuse.readFloats(GL_RGBA, 4);
            int different = 0;
            for (std::size_t k = 0; k < level.maps[i].irradiance.size(); ++k) {
                const float lit = diffuse[4 * (k / 3) + 3];
                const bool whole = lit == 0 || lit == 1;
                const double expected = double(level.maps[i].irradiance[k]);
                const double error = std::abs(double(slices.maps[i].irradiance[k]) - expected);
                different += error > (whole ? 0 : rounding * expected);
                halfShade += !whole && k % 3 == 0;
            }
            EXPECT_EQ(different, 0) << "values of map " << i << " with " << scene.caustics.planes
                                    << " planes";
        }
        EXPECT_GT(deposited, 0.01) << "there is light to compare";
        return halfShade;
    }
};

TEST_P(VolumetricIdentityGLTest, aReceiverAlone) {
    for (const double degrees : {0.0, 35.0})
        for (const int planes : {1, 4, 17}) {
            Scene scene = sceneOf(GetParam(), degrees, planes);
            addWaves(scene);
            const int halfShade = expectIdentity(scene);
            // Those with side maps shade themselves in them.
            if (std::string(GetParam()) == "floor" || std::string(GetParam()) == "hemisphere") {
                EXPECT_EQ(halfShade, 0);
            }
        }
}

TEST_P(VolumetricIdentityGLTest, inTheShadeOfAnother) {
    Scene scene = sceneOf(GetParam(), 35, 17);
    scene.receivers.push_back(scenes::floorAt(-1.6));
    scene.receivers.push_back(scenes::shape("ball", makeSphere(0.1, glm::vec3(0.8f)), {-0.2, -0.3, 0}));
    Light pointLight;
    pointLight.type = LightType::Point;
    pointLight.name = "lamp";
    pointLight.position = {0.6, 0.8, 0.3};
    scene.lights.push_back(pointLight);
    addWaves(scene);
    EXPECT_GT(expectIdentity(scene), 100) << "there is penumbra to compare";
}

INSTANTIATE_TEST_SUITE_P(receivers, VolumetricIdentityGLTest,
                         ::testing::Values("floor", "hemisphere", "sphere", "box", "teapot", "fish"),
                         [](const auto& receiver) { return std::string(receiver.param); });

TEST_F(VolumetricGLTest, heightFieldsHideNothing) {
    for (const char* receiver : {"floor", "hemisphere"}) {
        Engine& engine = sharedEngine();
        Scene scene = sceneOf(receiver, 0, 17);
        addWaves(scene);
        const Baked baked = bake(engine, scene);
        const Layers layers = layersOf(engine.maps()[0]);
        EXPECT_EQ(layers.hidden, 0) << receiver;
        EXPECT_GT(layers.seen, 10000) << receiver;
    }
}

TEST_F(VolumetricGLTest, aSpheresUndersideLightsUpInTheSlices) {
    // Slices do not shade each other: physics.md. Under flat water every column of a sphere takes the same
    // light once more below, but where its two sides share the middle slab, within half a gap of the equator:
    // 1 / (N - 1)² of the disc. A texel of the rim and of that border more or less is two of the 64 in a
    // radius.
    for (const int planes : {3, 5, 17}) {
        Engine& engine = sharedEngine();
        const Scene scene = sceneOf("sphere", 0, planes);
        bake(engine, scene);
        const Layers layers = layersOf(engine.maps()[0]);
        const double expected = 1 - 1.0 / ((planes - 1) * (planes - 1));
        printf("sphere, %d planes: %d of %d texels hide another, which takes %.4f of their light\n", planes,
               layers.hidden, layers.seen, layers.hiddenFluxPart());
        EXPECT_NEAR(layers.hiddenPart(), expected, 2.0 / 64);
        EXPECT_NEAR(layers.hiddenFluxPart(), expected, 2.0 / 64);
    }
}

TEST_F(VolumetricGLTest, aFloorAcrossManySlicesTakesAllOfTheLight) {
    // Seen along light from the side, a floor runs through every plane of its box.
    Scene scene = sceneOf("floor", 50, 17);
    scene.water.absorption = {0.5, 0.1, 0.02};
    const Baked baked = bake(scene, true);
    EXPECT_EQ(baked.planesDrawn.at(0), 17);
    const double cosIncident = std::cos(glm::radians(50.0)),
                 sinRefracted = std::sin(glm::radians(50.0)) / 1.333;
    const double path = 1 / std::sqrt(1 - sinRefracted * sinRefracted), area = 4;
    double expected = 0;
    for (int c = 0; c < 3; ++c)
        expected += area / 3 * cosIncident * optics::fresnelTransmittance(cosIncident, 1 / 1.333) *
                    optics::extinction(scene.water.absorption, path)[c];
    // As for the level map, under flat water: FlatWaterGLTest.
    EXPECT_NEAR(baked.maps[0].deposited, expected, 0.005 * expected);
    const FluxBalance& flux = baked.flux.at(0);
    EXPECT_LT(std::abs(flux.residual()), 0.01 * flux.entering);
}

TEST_F(VolumetricGLTest, memoryGrowsWithEveryPlane) {
    const std::int64_t texels = 128 * 128;
    std::int64_t levelMap = 0;
    sharedEngine().set(Scene());
    const std::int64_t held = context().ledger().total();
    {
        Engine engine(context());
        Scene scene = sceneOf("sphere", 0, 17);
        scene.caustics.method = Method::LevelMap;
        scene.caustics.fill = Fill::Drawn;
        bake(engine, scene);
        levelMap = context().ledger().total() - held;
    }
    for (const int planes : {3, 17, 101}) {
        Engine engine(context());
        bake(engine, sceneOf("sphere", 0, planes));
        EXPECT_EQ(context().ledger().bytes("slice images"), 16 * texels * planes);
        EXPECT_EQ(context().ledger().bytes("slice caustics"), 16 * texels * planes);
        EXPECT_EQ(context().ledger().total() - held, levelMap + 32 * texels * planes);
    }
    EXPECT_EQ(context().ledger().bytes("slice images"), 0) << "gone with the engine";
}

TEST_F(VolumetricGLTest, everyTexelOfTheSlicesIsWritten) {
    Engine engine(context());
    engine.setReuse(false);
    Scene scene = sceneOf("sphere", 20, 5);
    addWaves(scene);
    const Baked first = bake(engine, scene);
    const MapWork& maps = engine.maps()[0];
    const glm::vec4 sentinel(7);
    glClearTexImage(maps.slices.position.id(), 0, GL_RG, GL_FLOAT, &sentinel.x);
    glClearTexImage(maps.slices.normal.id(), 0, GL_RG, GL_FLOAT, &sentinel.x);
    glClearTexImage(maps.slices.caustics.id(), 0, GL_RGBA, GL_FLOAT, &sentinel.x);
    for (const gl::Texture* map : {&maps.level.position, &maps.level.normal, &maps.caustics.irradiance})
        glClearTexImage(map->id(), 0, GL_RGBA, GL_FLOAT, &sentinel.x);
    engine.updateCaustics(0);
    const MapData again = readMaps(maps, engine.origin());
    EXPECT_EQ(first.maps[0].irradiance, again.irradiance);
    EXPECT_EQ(first.maps[0].position, again.position);
    EXPECT_EQ(first.maps[0].normal, again.normal);
}

TEST_F(VolumetricGLTest, morePlanesThanLayersAreAnInputError) {
    const int most = context().info().maxTextureLayers;
    Engine& engine = sharedEngine();
    try {
        engine.set(sceneOf("floor", 0, most + 1));
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(
            std::string(error.what()),
            fmt::format("caustics.planes: expected at most {} with this GPU and method volumetric, found {}",
                        most, most + 1));
    }
}

} // namespace
} // namespace limpid
