#pragma once
#include <glm/glm.hpp>

#include "core/ShaderData.h"
#include "levelmap/ReceiverGeometry.h"
#include "plan/FlatWater.h"
#include "plan/Sides.h"
#include "scene/Scene.h"
#include "water/WaterSurface.h"

namespace limpid {

/// The camera and what it sees everything through, as shaders read it. Positions in m from the scene's
/// origin, radiance in W/(m² sr).
struct ViewFrameData : gpu::ViewFrame {
    bool cameraAbove() const { return cameraPosition.w > 0.5f; }
    /// The camera's side of the surface, and the other one.
    Side nearSide() const { return cameraAbove() ? Side::Above : Side::Below; }
    Side farSide() const { return cameraAbove() ? Side::Below : Side::Above; }
    /// Whether any receiver is on the camera's side of the surface, or on the other one.
    bool hasNearSide() const { return nearSideMin.w > 0.5f; }
    bool hasFarSide() const { return farSideMin.w > 0.5f; }
};

/// How much wider than the picture the views through and in the surface are, on each side as a share of the
/// picture's half width: waves look past its edge.
inline constexpr double viewMargin = 0.15;

/// y of the surface as it is drawn at the camera, m in the world: what decides whether the camera is under
/// water. Waits for the GPU, in one read, where the camera is as near to the level as waves are high.
double heightAtCamera(const Scene& scene, const glm::dvec3& origin, const WaterPatch& patch,
                      const WaterMesh& surface);

/// The frame of a picture of `samples` a side. `scene.camera` has position and target; `waterHeight` as
/// heightAtCamera has it.
ViewFrameData viewFrame(const Scene& scene, const glm::dvec3& origin, const WaterPatch& patch,
                        const SideBounds& sides, double waterHeight, glm::ivec2 samples);

} // namespace limpid
