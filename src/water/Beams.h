#pragma once
#include "gl/Context.h"
#include "gl/Handles.h"
#include "gl/Program.h"
#include "plan/LightFrame.h"
#include "scene/Scene.h"
#include "water/WaterSurface.h"

namespace limpid {

/// The illumination volumes of one light (thesis eq. 4-14): every method reads only these. Beam i is the
/// prism of refracted rays through the corners of water triangle i.
struct Beams {
    gl::Buffer origins;    ///< a vertex: vec4, m from the scene's origin, w = Fresnel transmittance [0, 1]
    gl::Buffer directions; ///< a vertex: vec4, unit, below the surface; w = 0
    gl::Buffer
        flux; ///< a triangle: float after Fresnel, m² (directional) or sr (point); times `strength` it is W
    gl::Buffer lit;   ///< a triangle: float, the share of its flux that things above the water leave
    gl::Buffer frame; ///< LightFrameData
    const gl::Texture* surfaceShadow = nullptr; ///< what those things leave dark; null if there are none
    const gl::Texture* pointLightShadow =
        nullptr; ///< what a point light under water sees; null for any other light
    glm::vec4 rect{0, 0, 1, 1};                 ///< sceneDepthRect of `frame`
    glm::dvec3 strength{0};                     ///< strengthOf its light
    int vertexCount = 0;
    int triangleCount = 0;
};

/// What a beam's flux is multiplied by, RGB, W/m² or W/sr; 0 for a light that does not enter the water.
glm::dvec3 strengthOf(const Light& light, const Water& water);

/// Refracts one light at every vertex of the surface and weighs every triangle.
class BeamTracer {
  public:
    explicit BeamTracer(gl::Context& context);

    /// Makes or reuses the buffers of `beams` for this light, and its frame.
    void prepare(Beams& beams, const WaterMesh& surface, const Light& light, const Water& water,
                 const LightFrameData& frame);
    /// Fills them. `surfaceShadow`: what is dark of the surface (levelmap/SurfaceShadow.h), null if nothing
    /// stands out of the water.
    void trace(Beams& beams, const WaterMesh& surface, const gl::Texture* surfaceShadow);

  private:
    gl::Context& _context;
    gl::Program _rays;
    gl::Program _flux;
};

} // namespace limpid
