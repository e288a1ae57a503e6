#pragma once
#include <array>
#include <optional>

#include "caustics/BeamLists.h"
#include "caustics/BeamTiles.h"
#include "caustics/CausticMap.h"
#include "caustics/FluxSums.h"
#include "gl/Program.h"
#include "levelmap/LevelMap.h"
#include "levelmap/PlaneDepths.h"
#include "plan/FlatWater.h"
#include "water/Beams.h"

namespace limpid {

/// The thesis's method (figure 4-15) in one compute pass: each beam finds the planes that it can meet, walks
/// the texels there, and gives its irradiance to those whose centre it covers on the texel's own plane.
/// Centres are tested as rasterisers do, so the result is that of DrawnPlanes but for texels within 1/256
/// texel of a beam's edge. Summed in integers: every run gives the same bits. Both `level-map` and
/// `level-map-smart`: planes without texels take no time.
class PlaneBeams {
  public:
    explicit PlaneBeams(gl::Context& context);

    struct Inputs {
        const LevelMap& map;
        const PlaneDepths& depths; ///< of `map`
        const Beams& beams;        ///< of the level map's light
        const WaterMesh& surface;
        const WaterPatch& patch; ///< that the surface covers
        const Water& water;
        const Light& light;
        const BeamCulling* culling = nullptr; ///< its list says which beams to ask about the map; null: all
        Colours colours = Colours::AsNeeded;
        int points = 1; ///< of the light's disc, of which `beams` are those of one
    };
    /// How the pass is run. One dispatch for each plane, as the thesis has it, gives the same bits as a
    /// single one.
    enum class Dispatch { Once, PlaneByPlane };

    /// Adds the light of one point of the light's disc to the sums.
    void deposit(const Inputs& inputs, Dispatch dispatch = Dispatch::Once);
    /// Overwrites `caustics` with the sums, which are zero afterwards. `inputs`: those of any point.
    void resolve(CausticMap& caustics, const Inputs& inputs);
    void fill(CausticMap& caustics, const Inputs& inputs, Dispatch dispatch = Dispatch::Once) {
        deposit(inputs, dispatch), resolve(caustics, inputs);
    }
    /// Gives back its memory until the next fill.
    void free() {
        _sums.free();
        _broad.free();
    }

  private:
    /// What plane_beams.comp is compiled for.
    struct Variant {
        bool paths, coloured, broad;
    };
    const gl::Program& program(const Variant& variant);
    void bind(const Inputs& inputs);
    void bindSums(const Inputs& inputs);
    void depositBetween(const Inputs& inputs, const glm::vec2& depths);
    gl::Context& _context;
    FluxSums _sums;
    std::array<std::optional<gl::Program>, 8> _programs; ///< compiled when first needed
    gl::Program _resolve;
    BeamLists _broad; ///< quads that touch many texels
};

} // namespace limpid
