#pragma once
#include "gl/Context.h"
#include "gl/Handles.h"
#include "gl/Program.h"
#include "godrays/GodrayTarget.h"

namespace limpid {

/// Shafts of light as lines from the surface to what they meet, drawn with additive blending into a target of
/// their own (Papadopoulos and Papaioannou 2009, 3.4). What is ours: a line carries the watts of its piece of
/// the water, and a pixel of it the radiance that these scatter to the camera, so that the sum is that of
/// single scattering; and a line is as wide as its piece of water, where that is wider on the screen than its
/// setting.
class PhotonLines {
  public:
    static bool does(GodrayMethod method) { return method == GodrayMethod::PhotonLines; }
    explicit PhotonLines(gl::Context& context);

    /// Adds to `target` the radiance that the water between the camera and what ends the view scatters to it.
    void draw(GodrayTarget& target, const GodrayInputs& inputs);

  private:
    void castLines(const GodrayInputs& inputs, const GodraySource& source);
    void drawLines(const GodrayInputs& inputs);
    gl::Context& _context;
    gl::Program _cast, _lines;
    gl::Buffer _ends;
    gl::VertexArray _noVertices;
};

} // namespace limpid
