#pragma once
#include "caustics/MapWork.h"
#include "caustics/StencilVolumes.h"

namespace limpid {

/// Caustics by depth and stencil test (StencilVolumes), with as many sub-volumes as there are planes.
class StencilMethod {
  public:
    static bool does(Method method) { return method == Method::Stencil; }
    explicit StencilMethod(gl::Context& context) : _planeDepths(context), _volumes(context) {}

    void draw(MapWork& map, const MapInputs& inputs) { drawLevelMap(map, inputs); }
    void prepare(MapWork& map, const MapInputs& inputs) { preparePlaneDepths(_planeDepths, map, inputs); }
    void fill(MapWork& map, const MapInputs& inputs, const WaterMesh& water) {
        _volumes.fill(map.caustics, map.level, map.depths, inputs.work.mapBeams(), inputs.work.mapMesh(water),
                      inputs.scene.water);
    }
    void free() { _volumes.free(); }

  private:
    PlaneDepthsPass _planeDepths;
    StencilVolumes _volumes;
};

} // namespace limpid
