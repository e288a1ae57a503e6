#pragma once
#include "caustics/BeamFootprints.h"
#include "gl/Program.h"
#include "levelmap/LevelMap.h"
#include "scene/Scene.h"
#include "water/Beams.h"

namespace limpid {

/// Rasterises the intersection triangles of all beams with a reference plane, with additive blending (thesis
/// 4.5): what every drawn method does once a plane. Sampling is at texel centres.
class PlaneDrawer {
  public:
    /// `fragmentShader` gives the irradiance of a beam (shaders/caustics/beam_irradiance.glsl) to the texels
    /// that belong to the plane.
    PlaneDrawer(gl::Context& context, const char* fragmentShader);

    /// The beams as the map's box sees them; must come before the first plane.
    void prepare(const LevelMap& map, const Beams& beams, const WaterMesh& surface, const Water& water);
    /// Adds to the framebuffer that is bound. Texture units 0 to 2 are the fragment shader's.
    void draw(const ReferencePlane& plane) const;
    /// Gives back its memory until the next `prepare`.
    void free() { _footprints.free(); }
    /// For uniforms of the fragment shader's own.
    const gl::Program& program() const { return _program; }

  private:
    BeamFootprints _footprints;
    gl::Program _program;
};

} // namespace limpid
