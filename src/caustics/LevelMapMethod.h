#pragma once
#include "caustics/BeamSums.h"
#include "caustics/DrawnPlanes.h"
#include "caustics/MapWork.h"
#include "caustics/PlaneBeams.h"

namespace limpid {

/// The thesis's method (figure 4-17): beams cut by reference planes, drawn plane by plane or in one pass;
/// with smart slicing (4.7.2) by the planes that texels belong to.
class LevelMapMethod {
  public:
    static bool does(Method method) { return method == Method::LevelMap || method == Method::LevelMapSmart; }
    explicit LevelMapMethod(gl::Context& context)
        : _slicing(context), _planeDepths(context), _drawnPlanes(context), _planeBeams(context),
          _sums(context) {}

    void draw(MapWork& map, const MapInputs& inputs);
    void prepare(MapWork& map, const MapInputs& inputs);
    void fill(MapWork& map, const MapInputs& inputs, const WaterMesh& water);
    void free() { _drawnPlanes.free(), _planeBeams.free(), _sums.free(); }

  private:
    void slice(LevelMap& map, const MapInputs& inputs);

    SmartSlicing _slicing;
    PlaneDepthsPass _planeDepths;
    DrawnPlanes _drawnPlanes;
    PlaneBeams _planeBeams;
    BeamSums _sums;
};

} // namespace limpid
