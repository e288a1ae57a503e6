#include "water/SceneWater.h"

#include "plan/WaveTerms.h"

namespace limpid {

void SceneWater::set(const Water& water, const WaterPatch& patch, const glm::dvec3& origin) {
    Shape shape{water, patch, origin};
    const Water still;
    shape.water.ior = still.ior;
    shape.water.absorption = still.absorption;
    shape.water.scattering = still.scattering;
    shape.water.anisotropy = still.anisotropy;
    if (_shapeStamp != 0 && shape == _shape) return;
    _shape = std::move(shape);
    _shapeStamp = _making.next();
    _moves = moves(water);
}

SceneWater::Moment SceneWater::moment(double time) const {
    return {_shapeStamp, _moves ? time : 0, _read};
}

void SceneWater::readHosts() {
    _read = isLive(_shape.water) ? _making.next() : 0;
}

const WaterMesh& SceneWater::at(double time) {
    _shown.bring(_making, moment(time), [&] {
        gl::PassTimers::Scope scope(_timers, "water");
        _surface.update(_shape.water, _shape.patch, _shape.origin, time);
    });
    return _surface.mesh();
}

} // namespace limpid
