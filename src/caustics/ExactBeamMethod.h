#pragma once
#include "caustics/BeamSums.h"
#include "caustics/ExactBeams.h"
#include "caustics/MapWork.h"

namespace limpid {

/// Our own method: beams cut by the tangent plane of every texel (ExactBeams).
class ExactBeamMethod {
  public:
    static bool does(Method method) { return method == Method::ExactBeam; }
    explicit ExactBeamMethod(gl::Context& context)
        : _tangentPlanes(context), _exactBeams(context), _sums(context) {}

    void draw(MapWork& map, const MapInputs& inputs) { drawLevelMap(map, inputs); }
    void prepare(MapWork& map, const MapInputs& inputs) {
        prepareTangentPlanes(_tangentPlanes, map, inputs, true);
    }
    void fill(MapWork& map, const MapInputs& inputs, const WaterMesh& water);
    void free() { _exactBeams.free(), _sums.free(); }

  private:
    TangentPlanesPass _tangentPlanes;
    ExactBeams _exactBeams;
    BeamSums _sums;
};

} // namespace limpid
