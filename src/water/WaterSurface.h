#pragma once
#include <glm/glm.hpp>

#include "gl/Context.h"
#include "gl/Handles.h"
#include "gl/Program.h"
#include "plan/FlatWater.h"
#include "scene/Scene.h"
#include "water/HeightMaps.h"

namespace limpid {

/// The moving surface as triangles on the GPU. Vertices: vec4 position, m from the scene's origin, w = 1;
/// vec4 unit normal. Triangles: three 32-bit indices, counter-clockwise from above; the diagonals of the
/// quads alternate.
struct WaterMesh {
    gl::Buffer positions;
    gl::Buffer normals;
    gl::Buffer indices;
    glm::ivec2 quads{0}; ///< along x and z
    int vertexCount = 0;
    int triangleCount = 0;
};

/// Fills the grid from the sum of the waves and height maps, heights and analytic normals, in one compute
/// pass.
class WaterSurface {
  public:
    explicit WaterSurface(gl::Context& context);

    /// `patch` in the world; `origin` is subtracted from every position; `time` in s. Throws
    /// InputError if a height map's frame cannot be loaded.
    void update(const Water& water, const WaterPatch& patch, const glm::dvec3& origin, double time);
    const WaterMesh& mesh() const { return _mesh; }

  private:
    void resize(glm::ivec2 grid);
    gl::Context& _context;
    gl::Program _program;
    HeightMaps _heightMaps;
    glm::ivec2 _grid{0};
    WaterMesh _mesh;
};

} // namespace limpid
