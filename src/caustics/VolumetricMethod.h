#pragma once
#include "caustics/MapWork.h"
#include "caustics/Volumetric.h"

namespace limpid {

/// The method that the level map was measured against (Volumetric). Its slices stand for the level map, whose
/// textures are there once they are combined.
class VolumetricMethod {
  public:
    static bool does(Method method) { return method == Method::Volumetric; }
    explicit VolumetricMethod(gl::Context& context) : _volumetric(context) {}

    void draw(MapWork& map, const MapInputs& inputs) {
        gl::PassTimers::Scope scope(inputs.timers, "slice images");
        _volumetric.drawSlices(map.slices, map.level, inputs.receiver);
    }
    void prepare(MapWork&, const MapInputs&) {}
    void fill(MapWork& map, const MapInputs& inputs, const WaterMesh& water) {
        _volumetric.drawCaustics(map.slices, map.level, inputs.work.mapBeams(), inputs.work.mapMesh(water),
                                 inputs.scene.water);
        _volumetric.combine(map.caustics, map.level, map.slices);
    }
    void free() { _volumetric.free(); }

  private:
    Volumetric _volumetric;
};

} // namespace limpid
