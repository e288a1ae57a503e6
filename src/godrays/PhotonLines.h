#pragma once
#include <span>

#include <glm/glm.hpp>

#include "gl/Context.h"
#include "gl/Handles.h"
#include "gl/Program.h"
#include "levelmap/ReceiverGeometry.h"
#include "levelmap/SceneDepthMap.h"
#include "scene/Scene.h"
#include "water/Beams.h"

namespace limpid {

/// Shafts of light as lines from the surface to what they meet, drawn with additive blending into a target of
/// their own (Papadopoulos and Papaioannou 2009, 3.4). What is ours: a line carries the watts of its piece of
/// the water, and a pixel of it the radiance that these scatter to the camera, so that the sum is that of
/// single scattering; and a line is as wide as its piece of water, where that is wider on the screen than its
/// setting.
class PhotonLines {
  public:
    explicit PhotonLines(gl::Context& context);

    /// A light that enters the water.
    struct Source {
        const Beams& beams;
        const SceneDepth& sceneDepth;
        double farthest; ///< m of water to the farthest receiver, at most
    };
    /// Where from and how large the picture is.
    struct Camera {
        glm::mat4 viewProjection; ///< depth from 1 near by to 0 far away; w: m along the view
        glm::vec3 position;       ///< under water, m from the scene's origin
        glm::ivec2 size;          ///< pixels
    };
    struct Inputs {
        const Scene& scene;
        const WaterMesh& surface;
        const WaterPatch& patch; ///< that the surface covers, in the world
        const glm::dvec3& origin;
        std::span<const ReceiverGeometry> receivers;
        std::span<const Source> sources;
        Camera camera;
    };
    /// RGBA32F, `scale` times the picture's size, row 0 at the bottom: W/(m² sr) that the water between the
    /// camera and the first receiver or the surface scatters to it; alpha 1 over the metres along the view to
    /// those, 0 for none. It stays until the next call.
    const gl::Texture& draw(const Inputs& inputs);

  private:
    void castLines(const Inputs& inputs, const Source& source);
    void drawDepth(const Inputs& inputs);
    gl::Buffer lineFrame(const Inputs& inputs, const Source& source) const;
    gl::Context& _context;
    gl::Program _cast, _lines, _depth, _surface;
    gl::Buffer _ends;
    gl::Texture _radiance;
    gl::VertexArray _noVertices;
};

/// Pixels of the target for a picture of `size`.
glm::ivec2 godrayTargetSize(glm::ivec2 size, double scale);

} // namespace limpid
