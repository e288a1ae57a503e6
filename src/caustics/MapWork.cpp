#include "caustics/MapWork.h"

namespace limpid {

using Scope = gl::PassTimers::Scope;

void drawLevelMap(MapWork& map, const MapInputs& inputs) {
    Scope scope(inputs.timers, "level map");
    inputs.levelMaps.draw(map.level, inputs.receiver);
}

void preparePlaneDepths(PlaneDepthsPass& pass, MapWork& map, const MapInputs& inputs) {
    if (inputs.unlit) {
        ++inputs.skipped.unreadPasses;
        return;
    }
    Scope scope(inputs.timers, "plane depths");
    pass.update(map.depths, map.level);
}

void prepareTangentPlanes(TangentPlanesPass& pass, MapWork& map, const MapInputs& inputs, bool withRims) {
    if (inputs.unlit) {
        ++inputs.skipped.unreadPasses;
        return;
    }
    Scope scope(inputs.timers, "tangent planes");
    if (!withRims || !inputs.occluders) {
        pass.update(map.tangents, map.level, nullptr);
        return;
    }
    const TangentPlanesPass::Rims rims{*inputs.occluders, inputs.work.beams, map.plan.receiver};
    pass.update(map.tangents, map.level, &rims);
}

} // namespace limpid
