#pragma once
#include <array>
#include <functional>
#include <optional>

#include "caustics/BeamFootprints.h"
#include "caustics/BeamLists.h"
#include "caustics/CausticMap.h"
#include "caustics/FluxSums.h"
#include "caustics/TangentPlanes.h"
#include "gl/Program.h"
#include "levelmap/LevelMap.h"
#include "occlusion/Occluders.h"
#include "water/Beams.h"

namespace limpid {

/// Our own method: compute passes over the beams, no planes. Each beam finds the depths that it meets in the
/// level map, walks the texels that it can touch there, and gives each the flux of the part of the beam that
/// the texel's tangent plane cuts out. The first pass does the quads whose texels lie in one plane that
/// nothing shades, and sorts the others into lists: quads on curved faces, and quads that may be shaded
/// (gathered touch by touch); of each, those that touch many texels are for work groups. Summed in integers:
/// every run gives the same bits.
class ExactBeams {
  public:
    /// Touches of quads that may be shaded, which wait for their pass: 16 MiB of them. Quads beyond are
    /// walked again in that pass.
    static constexpr std::int64_t mostTouches = 1 << 21;

    /// `touches`: room for so many.
    explicit ExactBeams(gl::Context& context, std::int64_t touches = mostTouches);

    struct Inputs {
        const LevelMap& map;
        int receiverNumber;          ///< as the occluders have it
        const TangentPlanes& planes; ///< of `map`
        const Occluders* occluders;  ///< null if nothing can be before the receiver
        const Beams& beams;          ///< of the level map's light
        const WaterMesh& surface;
        const WaterPatch& patch;
        const Water& water;
        const Light& light;
        const BeamCulling* culling = nullptr; ///< its list says which beams to ask about the map; null: all
        Colours colours = Colours::AsNeeded;
        int points = 1; ///< of the light's disc, of which `beams` are those of one
    };
    /// Adds the light of one point of the light's disc to the sums.
    void deposit(const Inputs& inputs);
    /// Overwrites `caustics` with the sums, which are zero afterwards. `inputs`: those of any point.
    void resolve(CausticMap& caustics, const Inputs& inputs);
    void fill(CausticMap& caustics, const Inputs& inputs) { deposit(inputs), resolve(caustics, inputs); }
    /// Gives back its memory until the next fill.
    void free() {
        _footprints.free();
        _sums.free();
        _lists.free();
        _touches = {};
    }

  private:
    /// The passes of a fill: all quads; those on curved faces; which texels the quads touch that may be
    /// shaded, and these touches.
    enum class Pass { AllQuads, ByTexel, Gather, Touches };
    /// What a program is compiled for.
    struct Variant {
        bool extinction, coloured, shaded, veiled, broad;
    };
    const gl::Program& program(Pass pass, const Variant& variant);
    void prepareLists(const Inputs& inputs);
    void bind(const Inputs& inputs) const;
    void set(const gl::Program& program, const Inputs& inputs, const Variant& variant,
             double stepsPerFlux) const;
    using Use = std::function<const gl::Program&(Pass pass, bool shaded, bool broad)>; ///< with uniforms set
    void doListed(const Use& use, Pass pass, int list) const;
    void doTouches(const gl::Program& program) const;
    void bindSums(const Inputs& inputs);

    gl::Context& _context;
    BeamFootprints _footprints;
    std::array<std::array<std::optional<gl::Program>, 32>, 4> _programs; ///< compiled when first needed
    FluxSums _sums;
    gl::Program _resolve;
    BeamLists _lists;
    std::int64_t _mostTouches;
    gl::Buffer _touches; ///< gpu::BeamTouches
};

} // namespace limpid
