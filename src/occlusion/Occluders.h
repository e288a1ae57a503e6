#pragma once
#include <memory>
#include <optional>
#include <span>

#include "gl/Context.h"
#include "gl/Handles.h"
#include "scene/Scene.h"

namespace limpid {

/// The triangles of all receivers as things that stand in light's way, in a bounding volume hierarchy on the
/// GPU: what shaders/occlusion/occluders.glsl reads. Light under waves goes its own way, so whether something
/// takes it is asked of the geometry itself and not of a picture of it: sheets without thickness, faces along
/// the light and things finer than a texel count like any other, at any size of a map.
class Occluders {
  public:
    /// Every receiver has a mesh; `origin`: what positions on the GPU are relative to, m.
    Occluders(gl::Context& context, std::span<const Receiver> receivers, const glm::dvec3& origin);

    /// To the storage blocks that the shaders read, 12 and up.
    void bind() const;
    /// Whether some of them let part of the light through: the shaders' variant VEILS.
    bool veiled() const { return _veiled; }
    /// Whether colours may differ in what they let through.
    bool coloured() const { return _coloured; }

  private:
    gl::Buffer _nodes, _triangles, _veils, _materials;
    bool _veiled = false, _coloured = false;
};

} // namespace limpid
