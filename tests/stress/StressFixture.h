#pragma once
#include <cmath>
#include <string>

#include "Folders.h"
#include "engine/EngineFixture.h"
#include "io/toml/SceneFile.h"

namespace limpid {

/// The scenes of profiles/scenes/stress, made small enough for every method in a few seconds.
class StressTest : public EngineGLTest {
  protected:
    static Engine& engine() { return sharedEngine(); }

    static Scene stressScene(const std::string& name, int grid = 96, int mapSize = 128) {
        const std::string cells = std::to_string(grid);
        return io::loadScene(std::filesystem::path(test::rootFolder()) / "profiles/scenes/stress" /
                                 (name + ".toml"),
                             {{"water.grid", "[" + cells + ", " + cells + "]"},
                              {"caustics.map_size", std::to_string(mapSize)},
                              {"caustics.planes", "8"}});
    }

    /// How many of `numbers` are no light: negative, infinite or none at all.
    static std::size_t impossible(std::span<const float> numbers) {
        return std::size_t(std::count_if(numbers.begin(), numbers.end(),
                                         [](float x) { return !(x >= 0) || std::isinf(x); }));
    }
    static std::size_t notFinite(std::span<const float> numbers) {
        return std::size_t(
            std::count_if(numbers.begin(), numbers.end(), [](float x) { return !std::isfinite(x); }));
    }

    static void expectLight(const Baked& baked, const std::string& what) {
        for (const MapData& map : baked.maps) {
            EXPECT_EQ(impossible(map.irradiance), 0u) << what;
            EXPECT_EQ(impossible(map.normalDotAxis), 0u) << what;
            EXPECT_EQ(notFinite(map.position) + notFinite(map.normal), 0u) << what;
            EXPECT_TRUE(map.deposited >= 0 && std::isfinite(map.deposited)) << what;
        }
        for (const FluxBalance& flux : baked.flux) {
            for (const double watts : {flux.entering, flux.absorbed, flux.scattered, flux.missed})
                EXPECT_TRUE(watts >= 0 && std::isfinite(watts)) << what << ": " << watts;
            EXPECT_TRUE(std::isfinite(flux.rejected)) << what;
        }
    }

    /// Of all lights together: what the one has too much does not make up for what the other lacks.
    static double residualShare(const Baked& baked) {
        double residual = 0, entering = 0, sum = 0;
        for (const FluxBalance& flux : baked.flux) {
            residual += std::abs(flux.residual()), entering += flux.entering;
            sum += flux.residual();
        }
        return entering > 0 ? std::copysign(residual / entering, sum) : residual;
    }

    /// Mean absolute difference of two maps over the mean of the second; all maps of a bake together.
    static double nmae(const Baked& a, const Baked& b) {
        double difference = 0, sum = 0;
        EXPECT_EQ(a.maps.size(), b.maps.size());
        for (std::size_t m = 0; m < std::min(a.maps.size(), b.maps.size()); ++m) {
            const auto &x = a.maps[m].irradiance, &y = b.maps[m].irradiance;
            EXPECT_EQ(x.size(), y.size());
            for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i)
                difference += std::abs(double(x[i]) - double(y[i])), sum += double(y[i]);
        }
        return sum > 0 ? difference / sum : difference;
    }

    /// The same scene `scale` times as large, and then moved by `shift`; its waves move with it.
    static Scene transformed(Scene scene, double scale, const glm::dvec3& shift = {}) {
        Water& water = scene.water;
        water.level = scale * water.level + shift.y;
        const glm::dvec2 across(shift.x, shift.z);
        if (water.center) water.center = scale * *water.center + across;
        if (water.size) *water.size *= scale;
        water.absorption /= scale;
        water.scattering /= scale;
        for (Wave& wave : water.waves) {
            wave.amplitude *= scale;
            wave.wavelength *= scale;
            wave.center = scale * wave.center + across;
            const double waves = glm::dot(glm::normalize(wave.direction), across) / wave.wavelength;
            if (wave.type == WaveType::Cosine) wave.phase -= 360 * (waves - std::floor(waves));
        }
        for (Light& light : scene.lights) {
            light.position = scale * light.position + shift;
            light.intensity *= scale * scale;
        }
        for (Receiver& receiver : scene.receivers) {
            receiver.translation = scale * receiver.translation + shift;
            receiver.scale *= scale;
        }
        return scene;
    }
};

} // namespace limpid
