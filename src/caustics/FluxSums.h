#pragma once
#include <cstdint>

#include "caustics/CausticMap.h"
#include "gl/Context.h"
#include "gl/Handles.h"
#include "levelmap/LevelMap.h"
#include "plan/FlatWater.h"
#include "scene/Scene.h"

namespace limpid {

/// Sums of flux in integers, 64 bits a texel and channel (shaders/interface/flux_sums.glsl): scratch that is
/// zero between maps.
class FluxSums {
  public:
    explicit FluxSums(gl::Context& context) : _context(context) {}

    /// Room for `count` sums, bound where compute shaders read them.
    void bind(std::int64_t count);
    /// Gives back its memory until the next map.
    void free() { _sums = {}; }

  private:
    gl::Context& _context;
    gl::Buffer _sums;
};

/// What one unit of a beam's flux is spread over where nothing focuses it, in its unit: the area of a texel,
/// m², or the solid angle that it has about at the point light, sr.
double unfocusedFlux(const LevelMap& map, const Light& light);

/// Flux of one step of the sums, of which the light of an unfocused texel has 2²²: rounding is then below a
/// float's, and the lower word holds a thousandfold focus.
double fluxPerStep(const LevelMap& map, const Light& light);

/// The same for sums over so many equal parts of a patch's light, of which each has at least 2¹⁴ steps: beams
/// of a lens are many, small and equal, so that all of them would be rounded alike.
double fluxPerStep(const LevelMap& map, const Light& light, const WaterPatch& patch, double parts);

/// Whether three numbers, by colour channel, are one.
inline bool isGrey(const glm::dvec3& v) {
    return v.x == v.y && v.y == v.z;
}

/// Sums of a texel: one if `colours` lets it stand for all three. `colouredVeils`: something in the light's way
/// lets some colours through and not others.
inline int channelsOf(Colours colours, const Water& water, bool colouredVeils = false) {
    return colours == Colours::All || colouredVeils || !isGrey(water.absorption + water.scattering) ? 3 : 1;
}

} // namespace limpid
