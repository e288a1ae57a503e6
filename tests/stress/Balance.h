#pragma once
#include <span>
#include <string_view>

#include <fmt/format.h>

#include "Folders.h"
#include "io/toml/ProfileFile.h"
#include "stress/StressFixture.h"

/// What becomes of the light of the scenes of profiles/stress.toml.
namespace limpid::stress {

/// A scene that a method cannot do by its nature, or by a fault that is not mended: how much of what enters
/// is unaccounted for, at most, and why.
struct Known {
    std::string_view scene;
    std::string_view methods; ///< names, or "all"
    double most;              ///< share of entering
    std::string_view why;
};

inline std::span<const Known> allKnown() {
    static constexpr std::string_view flatCosine =
        "it takes the cosine by flat water's light, which is far from the waves' here";
    static constexpr Known known[] = {
        {"lens", "level-map level-map-smart volumetric stencil", 1,
         "light is taken by texels' centres, and no beam that a lens makes so narrow covers one"},
        {"lamp-close", "photon-splat", 0.05,
         "photons are a cell of a grid wide, far wider than the lamp is high, and each has one direction"},
        {"grazing", "stencil", 0.05, flatCosine},
        {"low-sun", "stencil", 0.02, flatCosine},
        {"lights", "stencil", 0.02, flatCosine},
    };
    return known;
}

inline const Known* knownOf(std::string_view scene, Method method) {
    const std::string name = fmt::format(" {} ", methodName(method));
    for (const Known& known : allKnown())
        if (known.scene == scene &&
            (known.methods == "all" || fmt::format(" {} ", known.methods).find(name) != std::string::npos))
            return &known;
    return nullptr;
}

/// Of what enters, by the bars of the project.
inline double mostResidual(Method method) {
    return method == Method::ExactBeam ? 0.001 : 0.005;
}

struct NamedScene {
    std::string name;
    Scene scene;
    /// What is lost is lost at rims, a texel wide, and where crests shade, a quad wide: as much more may be
    /// where both are so much coarser than the scene has them.
    double coarser = 1;
};

/// As they are, or with maps and planes `coarser` times as coarse, and water of no more than `grid`² quads.
inline std::vector<NamedScene> stressScenes(int coarser, int grid) {
    const auto profile = io::loadProfile(std::filesystem::path(test::rootFolder()) / "profiles/stress.toml");
    std::vector<NamedScene> scenes;
    for (const auto& file : profile.scenes) {
        Scene scene = io::loadScene(file);
        scene.caustics.mapSize /= coarser;
        scene.caustics.planes = std::max(scene.caustics.planes / coarser, 4);
        const glm::ivec2 own = scene.water.grid;
        scene.water.grid = glm::min(own, glm::ivec2(grid));
        const double more = coarser * double(own.x) / scene.water.grid.x;
        scenes.push_back({file.stem().string(), std::move(scene), more});
    }
    return scenes;
}

} // namespace limpid::stress
