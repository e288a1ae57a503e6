#pragma once
#include "core/ShaderData.h"
#include "gl/Context.h"
#include "gl/Handles.h"
#include "gl/Program.h"
#include "levelmap/LevelMap.h"
#include "water/Beams.h"

namespace limpid {

/// The beams of a light by tiles of 8 × 8 quads of the water's grid.
struct BeamTiles {
    gl::Buffer bounds;  ///< gpu::RayBounds, a tile
    gl::Buffer reached; ///< a tile: uint, 1 if some map was asked about it since the bounds were made
    glm::ivec2 quads{0};

    static std::int64_t countOf(glm::ivec2 quads);
    std::int64_t count() const { return countOf(quads); }
    /// Beams in the tiles that some map was asked about. Waits for the GPU.
    std::int64_t reachedBeams() const;
};

/// Bounds the rays of each tile; needs to be done once for each surface.
class BeamTilesPass {
  public:
    explicit BeamTilesPass(gl::Context& context);
    void update(BeamTiles& tiles, const Beams& beams, const WaterMesh& surface);

  private:
    gl::Context& _context;
    gl::Program _bounds;
};

/// Finds the tiles that may send light to a map, so that a receiver costs by the beams that may reach it and
/// not by all.
class BeamCulling {
  public:
    explicit BeamCulling(gl::Context& context);

    /// What a map is asked about: a scratch list, overwritten for the next.
    /// Four uints: work groups of an indirect dispatch (x, y, z), tiles; beams in them; the tiles.
    const gl::Buffer& kept() const { return _kept; }
    /// Whose depths a pyramid holds: reference planes (levelmap/PlaneDepths.h), or as exact beams count them
    /// (caustics/TangentPlanes.h).
    enum class Depths { Planes, Leaning };
    /// Lists the tiles that may send a beam to the map; all others send none.
    void cull(const BeamTiles& tiles, const LevelMap& map, const gl::Texture& pyramid, Depths depths);
    /// For programs with shaders/caustics/tile_quads.glsl: all tiles, or those kept by `culling` unless that
    /// is null.
    static void dispatch(const gl::Program& program, const BeamCulling* culling, glm::ivec2 quads);
    /// Where in `kept` the number of beams is, bytes.
    static constexpr std::int64_t beamCountOffset = offsetof(gpu::Kept, keptBeams);

    /// Gives back its memory until the next `cull`.
    void free() { _kept = {}; }

  private:
    gl::Context& _context;
    gl::Program _cullPlanes, _cullLeaning;
    gl::Buffer _kept;
};

} // namespace limpid
