#include "caustics/LevelMapMethod.h"

namespace limpid {

using Scope = gl::PassTimers::Scope;

void LevelMapMethod::draw(MapWork& map, const MapInputs& inputs) {
    drawLevelMap(map, inputs);
    if (inputs.settings().method == Method::LevelMapSmart) slice(map.level, inputs);
}

void LevelMapMethod::slice(LevelMap& map, const MapInputs& inputs) {
    const CausticsSettings& settings = inputs.settings();
    Scope scope(inputs.timers, "slicing");
    if (settings.slicing == Slicing::Automatic && inputs.skipping) _slicing.dropEmptyPlanes(map);
    if (settings.slicing == Slicing::Levels)
        _slicing.sliceByLevels(map, settings.depthLevels, settings.threshold);
}

void LevelMapMethod::prepare(MapWork& map, const MapInputs& inputs) {
    if (inputs.settings().fill == Fill::Drawn) return;
    preparePlaneDepths(_planeDepths, map, inputs);
}

void LevelMapMethod::fill(MapWork& map, const MapInputs& inputs, const WaterMesh& water) {
    const WaterMesh& surface = inputs.work.mapMesh(water);
    if (inputs.settings().fill == Fill::Drawn) {
        _drawnPlanes.fill(map.caustics, map.level, inputs.work.mapBeams(), surface, inputs.scene.water);
        return;
    }
    _sums.fill(_planeBeams, map, inputs, map.depths.pyramid, BeamCulling::Depths::Planes,
               [&](const Beams& beams, const BeamCulling* culling, int points) {
                   return PlaneBeams::Inputs{
                       map.level,          map.depths,   beams,   surface,          inputs.plan.patch,
                       inputs.scene.water, inputs.light, culling, inputs.colours(), points};
               });
}

} // namespace limpid
