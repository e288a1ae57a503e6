#pragma once
#include <span>

#include "gl/Handles.h"
#include "gl/Program.h"
#include "plan/FlatWater.h"
#include "scene/Scene.h"
#include "view/ViewFrame.h"
#include "water/Beams.h"
#include "water/WaterSurface.h"

namespace limpid {

/// Draws the water's surface as the camera sees it, with what shows through it and in it.
class WaterPass {
  public:
    WaterPass();

    struct Inputs {
        const Scene& scene;
        const glm::dvec3& origin;
        const WaterPatch& patch;
        const WaterMesh& surface;
        const ViewFrameData& frame;
        std::span<const Beams* const> lights; ///< in the scene's order
        const gl::Texture *refracted, *refractedDistance;
        const gl::Texture *mirrored, *mirroredDistance;
    };
    /// Into the bound target, where the receivers on the camera's side are drawn already. The view frame is
    /// bound.
    void draw(const Inputs& inputs);

  private:
    void drawGrid(const Inputs& inputs);
    void drawHorizon(const Inputs& inputs);
    void addGlitter(const Inputs& inputs);

    gl::Program _water;
    gl::VertexArray _noVertices;
};

} // namespace limpid
