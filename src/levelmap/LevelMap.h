#pragma once
#include <vector>

#include "core/OrientedBox.h"
#include "gl/Context.h"
#include "gl/Handles.h"
#include "gl/Program.h"
#include "levelmap/Facings.h"
#include "levelmap/ReceiverGeometry.h"
#include "levelmap/ReferencePlanes.h"
#include "water/Beams.h"

namespace limpid {

/// The level map of one receiver and light (thesis 4.2): what the light sees of the receiver, and the planes
/// that its beams are cut with. Row 0 of the maps is the top of the box, u right, w down, one texel
/// `frame.texel` m wide.
struct LevelMap {
    TexelFrame frame;     ///< in the world
    gl::Buffer box;       ///< BoxFrame of shaders/include/box.glsl, m from the scene's origin
    gl::Texture position; ///< RG32F: depth along the light, m; plane index, -1 no receiver, -2 in shadow, -3
                          ///< inside of a solid
    gl::Texture diffuse;  ///< SRGB8_ALPHA8: base colour; share of the mean light that arrives
    gl::Texture normal;   ///< RG16: geometric normal facing the box's top, octahedral
    int facing = 0; ///< 0 the map along the light; k the further map that sees axis k - 1 of the facings
    int requestedPlanes = 0;
    std::vector<ReferencePlane> planes; ///< to be drawn, from the top down
};

/// Draws position, diffuse and normal map in one pass.
class LevelMapPass {
  public:
    explicit LevelMapPass(gl::Context& context);

    struct Inputs {
        const ReceiverGeometry& geometry;
        int receiverNumber;
        const Beams& beams;            ///< for the mean light
        const gl::Texture* sceneDepth; ///< null: nothing else can be before the receiver
        const Facings& facings;
        const DepthGradients& gradients; ///< of the faces that the map holds
    };

    /// `box` (in the world) runs along the mean light, or along the view of a further map; `mapSize` texels
    /// on its longer side. All planes are kept.
    void draw(LevelMap& map, const Inputs& inputs, const OrientedBox& box, int mapSize, int planes,
              const glm::dvec3& origin);

  private:
    void resize(LevelMap& map, glm::ivec2 size);
    gl::Context& _context;
    gl::Program _program;
};

/// Smart slicing (thesis 4.7.2): counts texels by depth on the GPU and leaves out planes that can hold
/// nothing.
class SmartSlicing {
  public:
    explicit SmartSlicing(gl::Context& context);

    /// Drops the planes that no lit texel belongs to.
    void dropEmptyPlanes(LevelMap& map);
    /// The thesis's own form: sub-boxes of the depth levels that hold texels, `threshold` of the box's
    /// height.
    void sliceByLevels(LevelMap& map, int depthLevels, double threshold);
    /// Texels by plane, or by depth level if `depthLevels` > 0. Waits for the GPU.
    std::vector<std::uint32_t> histogram(const LevelMap& map, int depthLevels = 0);

  private:
    gl::Context& _context;
    gl::Program _histogram;
    gl::Program _assign;
};

} // namespace limpid
