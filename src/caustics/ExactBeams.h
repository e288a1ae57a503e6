#pragma once
#include <array>
#include <optional>

#include "caustics/BeamFootprints.h"
#include "caustics/CausticMap.h"
#include "gl/Program.h"
#include "levelmap/LevelMap.h"
#include "levelmap/TangentPlanes.h"
#include "water/Beams.h"

namespace limpid {

/// Our own method: one compute pass over the beams, no planes. Each beam finds the depths that it meets in
/// the level map, walks the texels that it can touch there, and gives each the flux of the part of the beam
/// that the texel's tangent plane cuts out. Summed in integers: every run gives the same bits.
class ExactBeams {
  public:
    explicit ExactBeams(gl::Context& context);

    struct Inputs {
        const LevelMap& map;
        int receiverNumber;           ///< as in the scene depth map
        const TangentPlanes& planes;  ///< of `map`
        const SceneDepth* sceneDepth; ///< of the light; null if nothing can be before the receiver
        const Beams& beams;           ///< of the level map's light
        const WaterMesh& surface;
        const Water& water;
        const Light& light;
    };
    /// Overwrites `caustics`.
    void fill(CausticMap& caustics, const Inputs& inputs);
    /// Gives back its memory until the next fill.
    void free() {
        _footprints.free();
        _sums = {};
        _largeBeams = {};
    }

  private:
    void reserveSums(std::int64_t count);
    void deposit(const Inputs& inputs, bool coloured, double stepsPerFlux);
    gl::Context& _context;
    BeamFootprints _footprints;
    /// What a dispatch of exact_beams.comp is compiled for.
    struct Variant {
        bool paths, coloured, large;
    };
    const gl::Program& program(const Variant& variant);
    std::array<std::optional<gl::Program>, 8> _programs; ///< compiled when first needed
    gl::Program _resolve;
    gl::Buffer _sums;       ///< zero between maps
    gl::Buffer _largeBeams; ///< as exact_beams.comp has it
};

} // namespace limpid
