#include "caustics/ExactBeamMethod.h"

namespace limpid {

void ExactBeamMethod::fill(MapWork& map, const MapInputs& inputs, const WaterMesh& water) {
    _sums.fill(_exactBeams, map, inputs, map.tangents.depthPyramid, BeamCulling::Depths::Leaning,
               [&](const Beams& beams, const BeamCulling* culling, int points) {
                   return ExactBeams::Inputs{map.level,
                                             map.plan.receiver,
                                             map.tangents,
                                             inputs.occluders,
                                             beams,
                                             inputs.work.mapMesh(water),
                                             inputs.plan.patch,
                                             inputs.scene.water,
                                             inputs.light,
                                             culling,
                                             inputs.colours(),
                                             points};
               });
}

} // namespace limpid
