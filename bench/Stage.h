#pragma once
#include <compare>
#include <optional>
#include <string>

#include "caustics/TangentPlanes.h"
#include "levelmap/LevelMap.h"
#include "occlusion/Occluders.h"
#include "water/Beams.h"
#include "water/WaterSurface.h"

namespace limpid::bench {

/// What a benchmark varies.
struct StageSize {
    std::string receiver = "floor"; ///< "floor", 2 m by 2 m, or a model of models/
    int quads = 256;                ///< of the water, a side; two beams each
    int mapSize = 512;              ///< texels on the longer side of the receiver's map
    int planes = 17;

    auto operator<=>(const StageSize&) const = default;
    int beams() const { return 2 * quads * quads; }
};

/// One receiver a metre and a half under wavy water and a high sun, done up to the point where a caustic map
/// can be filled: what any pass of a frame may take. The floor lies a metre deep under a vertical sun and
/// water of its own size, so that every beam falls on it but for a few at the edges.
struct Stage {
    Stage(gl::Context& context, const StageSize& size);

    gl::Context& context;
    StageSize size;
    Scene scene;
    WaterPatch patch;
    WaterSurface surface;
    BeamTracer tracer;
    Beams beams;
    ReceiverGeometry geometry;
    LevelMapPass levelMapPass;
    LevelMap map; ///< all planes
    TangentPlanes tangents;

    LitReceiver receiver() const { return {geometry, 0, beams, nullptr}; }
    /// Null for the floor, which nothing shades.
    const Occluders* occluders() const { return _occluders ? &*_occluders : nullptr; }

  private:
    std::optional<Occluders> _occluders;
};

} // namespace limpid::bench
