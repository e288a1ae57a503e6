#pragma once
#include "caustics/BeamTiles.h"
#include "gl/Context.h"
#include "gl/Handles.h"
#include "gl/Program.h"
#include "levelmap/LevelMap.h"
#include "water/Beams.h"

namespace limpid {

/// The beams of a light as one receiver's box sees them: scratch, overwritten for the next receiver.
class BeamFootprints {
  public:
    explicit BeamFootprints(gl::Context& context);

    void update(const Beams& beams, const WaterMesh& surface, const LevelMap& map);
    /// The rays alone, without the areas; `culling`: only those of the tiles that it keeps, unless null.
    void updateRays(const Beams& beams, const WaterMesh& surface, const LevelMap& map,
                    const BeamCulling* culling = nullptr);

    /// Gives back its memory until the next update.
    void free();

    const gl::VertexArray& vertexArray() const { return _vertexArray; }
    /// A vertex: vec4, the texel that its ray meets at depth 0 and how it moves by m of depth.
    const gl::Buffer& rays() const { return _footprints; }
    /// A vertex: float, depth at which its ray begins, m.
    const gl::Buffer& originDepths() const { return _originDepths; }
    /// A triangle: vec4, twice its area in texels as c0 + c1 z + c2 z² of the depth z in m; flux as in Beams.
    const gl::Buffer& areas() const { return _areas; }
    int triangleCount() const { return _triangleCount; }

  private:
    void resize(const Beams& beams, const WaterMesh& surface);
    gl::Context& _context;
    gl::Program _rays, _tileRays, _area;
    gl::Buffer _footprints, _originDepths, _areas;
    gl::VertexArray _vertexArray;
    int _vertexCount = 0, _triangleCount = 0;
};

} // namespace limpid
