#pragma once
#include "gl/Context.h"
#include "gl/Handles.h"
#include "gl/Program.h"
#include "godrays/GodrayTarget.h"

namespace limpid {

/// Shafts of light as illumination volumes, each cut along its length into sub-volumes and those into three
/// tetrahedra, drawn with additive blending as the triangles that they make on the screen (Iwasaki, Dobashi
/// and Nishita 2002, 3). What is ours: a tetrahedron is as thick in each pixel as it is there, and ends at
/// what the camera sees; what intersects itself is cut and kept; a sub-volume holds the watts that pass
/// through it; and the number of sub-volumes follows from what the water takes.
class Tetrahedra {
  public:
    static bool does(GodrayMethod method) { return method == GodrayMethod::Tetrahedra; }
    explicit Tetrahedra(gl::Context& context);

    /// Adds to `target` the radiance that the water between the camera and what ends the view scatters to it.
    void draw(GodrayTarget& target, const GodrayInputs& inputs);

  private:
    void sweep(const GodrayInputs& inputs, const GodraySource& source);
    void cut(const GodrayInputs& inputs);
    void drawPieces(const GodrayInputs& inputs);
    gl::Context& _context;
    gl::Program _sweep, _pieces, _starts, _draw;
    gl::Buffer _rays, _flux, _volumeStarts;
    gl::VertexArray _noVertices;
};

} // namespace limpid
