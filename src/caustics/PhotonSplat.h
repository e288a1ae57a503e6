#pragma once
#include <array>
#include <optional>

#include "caustics/CausticMap.h"
#include "caustics/FluxSums.h"
#include "caustics/TangentPlanes.h"
#include "gl/Program.h"
#include "levelmap/LevelMap.h"
#include "occlusion/Occluders.h"
#include "scene/Scene.h"
#include "water/Beams.h"

namespace limpid {

/// Photons on a grid, refracted once, intersected with what the light sees, and drawn as splats (Papadopoulos
/// and Papaioannou 2009, 3.1 to 3.3 and 3.5), into a receiver's map seen from its box. What is ours: a photon
/// carries the watts of its piece of the surface, so that the map is irradiance; it lands only if nothing is
/// in its way; a splat and the filter give their light to the surface that it fell on and to nothing beside
/// it; sums are integers.
///
/// In the paper a splat's size follows the distance from the viewer. A map is seen along the light, from the
/// water: d of s = a + b/d is metres of water.
class PhotonSplat {
  public:
    explicit PhotonSplat(gl::Context& context);

    struct Inputs {
        const LevelMap& map;
        int receiver;                ///< its number
        const TangentPlanes& planes; ///< of the level map
        const Occluders* occluders;  ///< null: nothing can be before the receiver
        const Beams& beams;          ///< of the level map's light
        const WaterMesh& surface;
        const WaterPatch& patch; ///< that the surface covers, in the world
        const glm::dvec3& origin;
        const Scene& scene; ///< its settings and water
        const Light& light;
        const Bounds& wet; ///< of the receiver below the level, in the world
        Colours colours = Colours::AsNeeded;
    };
    /// Overwrites `caustics`.
    void fill(CausticMap& caustics, const Inputs& inputs);
    /// Gives back its memory until the next fill.
    void free() {
        _splats = {};
        _sums = {};
        _left = {};
    }

  private:
    /// All photons; those that the first pass has left.
    enum class Pass { All, Left };
    /// How photons of a map are cast.
    struct Cast {
        const WaterPatch& photons; ///< their grid
        const glm::vec4& splat;    ///< a, b, least and greatest size, texels
        int channels;
        double stepsPerFlux;
    };
    const gl::Program& castProgram(Pass pass, bool veiled);
    void bind(const Inputs& inputs) const;
    void set(const gl::Program& cast, const Inputs& inputs, const Cast& settings) const;
    void reserveSums(std::int64_t texels, int channels, bool filtered);
    void cast(const Inputs& inputs, const Cast& settings);
    void filter(const Inputs& inputs, int channels);
    gl::Context& _context;
    std::array<std::optional<gl::Program>, 3> _cast; ///< all photons; those left, without and with veils
    gl::Program _filter, _resolve;
    gl::Buffer _splats, _sums; ///< zero between maps
    gl::Buffer _left;          ///< photons that the first pass leaves to the second
};

/// What `s = a + b / d` (Papadopoulos 3.3) has for a and b so that the size is `sizes.y` at `nearest` metres
/// and `sizes.x` at `farthest`. Where both are one distance: the smaller size everywhere.
glm::dvec2 splatSizes(const glm::dvec2& sizes, double nearest, double farthest);

} // namespace limpid
