#pragma once
#include "caustics/MapWork.h"
#include "caustics/PhotonSplat.h"

namespace limpid {

/// Photons on a grid, drawn as splats (PhotonSplat).
class PhotonSplatMethod {
  public:
    static bool does(Method method) { return method == Method::PhotonSplat; }
    explicit PhotonSplatMethod(gl::Context& context) : _tangentPlanes(context), _splat(context) {}

    void draw(MapWork& map, const MapInputs& inputs) { drawLevelMap(map, inputs); }
    void prepare(MapWork& map, const MapInputs& inputs) {
        prepareTangentPlanes(_tangentPlanes, map, inputs, false);
    }
    void fill(MapWork& map, const MapInputs& inputs, const WaterMesh& water) {
        _splat.fill(map.caustics,
                    {map.level, map.plan.receiver, map.tangents, inputs.occluders, inputs.work.beams, water,
                     inputs.plan.patch, inputs.plan.origin, inputs.scene, inputs.light,
                     inputs.plan.receivers[std::size_t(map.plan.receiver)].wet, inputs.colours()});
    }
    void free() { _splat.free(); }

  private:
    TangentPlanesPass _tangentPlanes;
    PhotonSplat _splat;
};

} // namespace limpid
