#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "caustics/BeamTiles.h"
#include "core/Kept.h"
#include "levelmap/SceneDepthMap.h"
#include "plan/LightFrame.h"
#include "water/Beams.h"
#include "water/SceneWater.h"

namespace limpid {

/// Beams of one more point of a light's disc.
struct DiscPoint {
    Beams beams;
    BeamTiles tiles;
};

/// The water in finer quads for a point light that is close to it, and the beams that its maps are filled
/// with.
struct PointLightWater {
    WaterPatch patch;
    WaterSurface surface;
    Beams beams;
};

/// One light: its beams, and first hits of its mean light.
struct LightWork {
    Beams beams;
    std::unique_ptr<PointLightWater> pointLightWater; ///< empty where the water's own quads are fine enough
    SceneDepth sceneDepth;
    gl::Texture surfaceShadow;    ///< empty if nothing stands out of the water
    gl::Texture pointLightShadow; ///< empty unless a point light is under water and a picture shows it
    BeamTiles tiles;              ///< where beams are culled many at a time
    std::vector<DiscPoint> disc;  ///< besides its middle, whose beams are `beams`; empty for a point far away

    /// The beams that fill maps; pictures and godrays take `beams`.
    const Beams& mapBeams() const { return pointLightWater ? pointLightWater->beams : beams; }
    /// The surface that those begin at; `water`: the scene's.
    const WaterMesh& mapMesh(const WaterMesh& water) const {
        return pointLightWater ? pointLightWater->surface.mesh() : water;
    }
    /// True for a light that gives none.
    bool isDark() const { return beams.strength == glm::dvec3(0); }

    struct FrameFrom {
        LightFrameData frame;
        glm::ivec2 grid{0};
        bool operator==(const FrameFrom&) const = default;
    };
    struct ShadowFrom {
        LightFrameData frame; ///< as its shader reads it
        std::vector<Stamp> receivers;
        bool operator==(const ShadowFrom&) const = default;
    };
    struct TracedFrom {
        SceneWater::Moment water;
        LightFrameData frame; ///< as beams read it
        Stamp surfaceShadow = 0;
        bool dark = false; ///< and not traced
        std::optional<WaterPatch> pointLightPatch;
        std::vector<LightFrameData> disc;
        bool tiled = false;
        bool operator==(const TracedFrom&) const = default;
    };
    struct FirstHitsFrom {
        LightFrameData frame;
        glm::ivec2 size{0}; ///< texels
        double farthest = 1;
        std::vector<Stamp> receivers;
        bool operator==(const FirstHitsFrom&) const = default;
    };
    Kept<FrameFrom> framed;         ///< buffers of `beams` and its frame
    Kept<ShadowFrom> shadowed;      ///< `surfaceShadow`
    Kept<TracedFrom> traced;        ///< all beams and tiles
    Kept<FirstHitsFrom> firstHits;  ///< `sceneDepth`
    Kept<ShadowFrom> pointLightSurrounds; ///< `pointLightShadow`
};

} // namespace limpid
