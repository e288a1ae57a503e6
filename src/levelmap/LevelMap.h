#pragma once
#include <vector>

#include "core/OrientedBox.h"
#include "gl/Context.h"
#include "gl/Handles.h"
#include "gl/Program.h"
#include "levelmap/ReceiverGeometry.h"
#include "levelmap/ReferencePlanes.h"
#include "plan/Facings.h"
#include "water/Beams.h"

namespace limpid {

/// The level map of one receiver and light (thesis 4.2): what the light sees of the receiver, and the planes
/// that its beams are cut with. Row 0 of the maps is the top of the box, u right, w down, one texel
/// `frame.texel` m wide.
struct LevelMap {
    TexelFrame frame;     ///< in the world
    gl::Buffer box;       ///< gpu::BoxFrame
    gl::Texture position; ///< RG32F: depth along the light, m; plane index, -1 no receiver, -2 in shadow, -3
                          ///< inside of a solid
    gl::Texture diffuse;  ///< SRGB8_ALPHA8: base colour; share of the mean light that arrives
    gl::Texture normal;   ///< RG16: geometric normal facing the box's top, octahedral
    int facing = 0;       ///< 0 the map along the light; k the side map that sees axis k - 1 of the facings
    int requestedPlanes = 0;
    std::vector<ReferencePlane> planes; ///< to be drawn, from the top down
};

/// What a level map is laid out by.
struct LevelMapLayout {
    const OrientedBox& box; ///< in the world, along the mean light or along the view of a side map
    const Facings& facings;
    const DepthGradients& gradients; ///< of the faces that the map holds
    int mapSize;                     ///< texels on the longer side of the box
    int planes;
    glm::dvec3 origin; ///< that positions on the GPU are relative to
};
/// Gives `map` its frame, all of its planes and textures of the right size, whose content is yet to be drawn.
void prepareLevelMap(gl::Context& context, LevelMap& map, const LevelMapLayout& layout);

/// A receiver, and what may keep the mean light from it.
struct LitReceiver {
    const ReceiverGeometry& geometry;
    int number;
    const Beams& beams;            ///< for the mean light
    const gl::Texture* sceneDepth; ///< null: nothing else can be before the receiver

    /// Sets what shaders/levelmap/level_map_texel.glsl reads for a prepared map, and draws.
    void draw(const gl::Program& program, const LevelMap& map) const;
};

/// Draws position, diffuse and normal map in one pass.
class LevelMapPass {
  public:
    explicit LevelMapPass(gl::Context& context);

    /// Into a map that is prepared.
    void draw(LevelMap& map, const LitReceiver& receiver);

  private:
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
