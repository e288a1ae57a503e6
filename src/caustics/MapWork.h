#pragma once
#include <optional>
#include <vector>

#include "caustics/CausticMap.h"
#include "caustics/LightWork.h"
#include "caustics/Slices.h"
#include "caustics/TangentPlanes.h"
#include "core/Kept.h"
#include "core/Skipped.h"
#include "gl/TimerQuery.h"
#include "levelmap/LevelMap.h"
#include "levelmap/PlaneDepths.h"
#include "occlusion/Occluders.h"
#include "plan/Plan.h"

namespace limpid {

/// The maps of one receiver and one light.
struct MapWork {
    PlannedMap plan;
    std::vector<int> shadedBy; ///< numbers of the receivers that may be in its light's way (mayShade)
    int halvings = 0;          ///< of its size and planes, where a picture shows it small
    LevelMap level;
    TangentPlanes tangents; ///< for exact beams and photon splats only
    PlaneDepths depths;     ///< for level maps in one pass and for stencil only
    Slices slices;          ///< for the volumetric method only
    CausticMap caustics;
    gl::Texture
        taken; ///< shares of its light (occlusion/TakenLight.h); empty where light goes through nothing
    bool culled = false;   ///< whether the last update has culled beams of which none could reach it
    gl::Buffer askedBeams; ///< a uint: how many it has not culled

    /// All but the light is there.
    bool isDrawn() const { return prepared.stamp() != 0; }
    /// Its light is there.
    bool isFilled() const { return filled.stamp() != 0; }

    /// Inputs of the mean light's shade on a level map.
    struct ShadeFrom {
        glm::vec4 rect{0}; ///< LightFrameData::sceneDepthRect
        glm::ivec2 size{0};
        double farthest = 1;
        std::vector<Stamp> shadedBy;
        bool operator==(const ShadeFrom&) const = default;
    };
    struct SlicingFrom {
        Slicing slicing;
        int depthLevels;
        double threshold;
        bool skipping;
        bool operator==(const SlicingFrom&) const = default;
    };
    struct LevelFrom {
        PlannedMap plan;
        int size = 0, planes = 0;
        glm::dvec3 origin{0};
        Method method{};
        Stamp receiver = 0;
        LightFrameData frame;
        std::optional<ShadeFrom> shade;     ///< where the mean light may be shaded
        std::optional<SlicingFrom> slicing; ///< of methods that slice
        bool operator==(const LevelFrom&) const = default;
    };
    struct PreparedFrom {
        Stamp level = 0;
        Fill fill{};
        bool unlit = false, skipping = true;
        std::vector<Stamp> shadedBy;
        bool operator==(const PreparedFrom&) const = default;
    };
    struct FilledFrom {
        Stamp prepared = 0, beams = 0;
        Light light;
        glm::dvec3 absorption{0}, scattering{0};
        CausticsSettings settings;
        std::optional<double> farthest; ///< of a light with a disc
        bool unlit = false, skipping = true;
        std::vector<Stamp> shadedBy;
        bool operator==(const FilledFrom&) const = default;
    };
    Kept<LevelFrom> drawn;       ///< `level`, and what of it is sliced
    Kept<PreparedFrom> prepared; ///< what the method reads beside it
    Kept<FilledFrom> filled;     ///< `caustics`
};

/// What a method makes a map from and with.
struct MapInputs {
    gl::PassTimers& timers;
    Skipped& skipped;
    LevelMapPass& levelMaps;
    const Scene& scene;
    const Plan& plan;
    const Light& light;
    const LightWork& work; ///< of this light
    LitReceiver receiver;
    const Occluders* occluders; ///< of beams on their ways; null if nothing can be before the receiver
    bool unlit;                 ///< and need not be filled
    bool skipping;              ///< work may be left out

    Colours colours() const { return skipping ? Colours::AsNeeded : Colours::All; }
    const CausticsSettings& settings() const { return scene.caustics; }
};

// What several methods do alike.

/// Draws `map.level`, which is laid out.
void drawLevelMap(MapWork& map, const MapInputs& inputs);
/// Makes `map.depths`; not of a map that is unlit.
void preparePlaneDepths(PlaneDepthsPass& pass, MapWork& map, const MapInputs& inputs);
/// Makes `map.tangents`, `withRims`: those of texels that show more than the surface at their middle; not of
/// a map that is unlit.
void prepareTangentPlanes(TangentPlanesPass& pass, MapWork& map, const MapInputs& inputs, bool withRims);

} // namespace limpid
