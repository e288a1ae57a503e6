#pragma once
#include <cmath>
#include <cstdio>
#include <vector>

#include "engine/EngineFixture.h"
#include "plan/FlatWater.h"
#include "plan/MapPlan.h"
#include "reference/Scattering.h"

namespace limpid {

/// What a way to draw light in the water adds to pictures, against single scattering.
class GodraysGLTest : public EngineGLTest {
  protected:
    static constexpr glm::ivec2 pictureSize{48, 40};

    /// A camera in a tank of 2 · 2 m and 1.2 m of water, a ball in it, waves over it, a slanting sun. Pixel
    /// by pixel and without a filter.
    static Scene tank(GodrayMethod method) {
        Scene scene;
        scene.receivers = {scenes::floorAt(-1.2),
                           scenes::shape("ball", makeSphere(0.2, glm::vec3(1)), {0.2, -0.6, 0})};
        scene.lights = {scenes::sunAt(30)};
        scene.water.waves = {scenes::cosine(0.01, 0.4, {1, 0.3})};
        scene.water.center = glm::dvec2(0);
        scene.water.size = glm::dvec2(2);
        scene.water.grid = glm::ivec2(128);
        scene.water.scattering = {0.3, 0.25, 0.2};
        scene.water.absorption = {0.3, 0.1, 0.05};
        scene.water.anisotropy = 0.6;
        scene.caustics.mapSize = 32;
        scene.camera.position = glm::dvec3(-0.1, -0.5, 2.2);
        scene.camera.target = glm::dvec3(0, -0.6, 0);
        scene.ambientRadiance = glm::dvec3(0);
        scene.godrays.method = method;
        scene.godrays.scale = 1;
        scene.godrays.filterTaps = 0;
        return scene;
    }

    /// RGB, rows from the top, in double.
    static std::vector<double> added(Scene scene, glm::ivec2 size = pictureSize) {
        Engine engine(context());
        engine.set(scene);
        const Picture with = engine.render(0, size);
        scene.godrays.method = GodrayMethod::None;
        engine.set(scene);
        const Picture without = engine.render(0, size);
        std::vector<double> sum;
        for (std::size_t i = 0; i < with.rgb.size(); ++i)
            sum.push_back(double(with.rgb[i]) - double(without.rgb[i]));
        return sum;
    }

    static reference::ScatterImage truthOf(const Scene& scene, std::int64_t photons,
                                           glm::ivec2 size = pictureSize) {
        const WaterPatch patch = coveringPatch(scene);
        return reference::scatteredLight(
            reference::scatterView(scene.camera, sceneOrigin(scene), size),
            {scene, 0, sceneOrigin(scene), patch.min(), patch.size, photons, 1, 2});
    }

    struct Error {
        double nmae, ratio;
    };
    static Error errorOf(const std::vector<double>& image, const reference::ScatterImage& truth,
                         const char* name) {
        double error = 0, sum = 0, whole = 0;
        for (std::size_t i = 0; i < image.size(); ++i) {
            const double right = truth.radiance[i / 3][int(i % 3)];
            error += std::abs(image[i] - right);
            sum += image[i];
            whole += right;
        }
        printf("%s: nMAE %.2f %%, sum %.4f (reference by chance %.2f %%)\n", name, 100 * error / whole,
               sum / whole, 100 * truth.standardError);
        return {error / whole, sum / whole};
    }

    static void expectShadeIsDark(const Scene& scene) {
        const Error error = errorOf(added(scene), truthOf(scene, 200000), "past a ball");
        EXPECT_NEAR(error.ratio, 1, 0.01);
        EXPECT_LT(error.nmae, 0.035);
    }

    /// `scene` under a point light in place of its sun.
    static void expectLampsLight(Scene scene) {
        scene.lights[0].type = LightType::Point;
        scene.lights[0].position = {0.4, 1.5, 0.3};
        scene.lights[0].intensity = glm::dvec3(3, 2, 1);
        const Error error = errorOf(added(scene), truthOf(scene, 200000), "under a lamp");
        EXPECT_NEAR(error.ratio, 1, 0.015);
        EXPECT_LT(error.nmae, 0.035);
    }

    static void expectTheSameBits(const Scene& scene) {
        Engine engine(context());
        engine.set(scene);
        const std::vector<float> first = engine.render(0, pictureSize).rgb;
        EXPECT_EQ(engine.render(0, pictureSize).rgb, first);
        for (const float value : first)
            ASSERT_TRUE(std::isfinite(value));
    }

    /// Without scattering nothing is made, and not a bit of the picture is another.
    static void expectNothingWithoutScattering(GodrayMethod method) {
        Scene scene = tank(method);
        scene.water.scattering = glm::dvec3(0);
        Engine engine(context());
        engine.set(scene);
        const std::vector<float> with = engine.render(0, pictureSize).rgb;
        for (const auto& [pass, ms] : engine.timers().collect())
            EXPECT_NE(pass, "godrays");
        for (const char* kind : {"godrays", "photon lines", "lit water", "illumination volumes"})
            EXPECT_EQ(context().ledger().byKind().count(kind), 0u) << kind;
        scene.godrays.method = GodrayMethod::None;
        engine.set(scene);
        EXPECT_EQ(engine.render(0, pictureSize).rgb, with);
    }
};

} // namespace limpid
