#pragma once
#include <optional>

#include <glm/glm.hpp>

#include "scene/Scene.h"

namespace limpid::viewer {

/// A ray of light backwards: from `origin` along the unit `direction`. World, m.
struct Ray {
    glm::dvec3 origin{0};
    glm::dvec3 direction{0, 0, -1};
};

/// Where a picture shows the points of a scene, seen through flat water (shaders/view/view.glsl without
/// the waves). Pixels count from the upper left corner.
class Projection {
  public:
    /// `camera` has position and target; `size` of the picture, pixels.
    Projection(const Camera& camera, const Water& water, const glm::dvec2& size);

    /// None behind the camera.
    std::optional<glm::dvec2> pixel(const glm::dvec3& point) const;
    /// From the camera through a pixel, up to the surface.
    Ray ray(const glm::dvec2& pixel) const;
    /// Where the way from the camera to `point` crosses the flat surface; `point` itself on the camera's
    /// side.
    glm::dvec3 seenAt(const glm::dvec3& point) const;
    /// Metres that a pixel is wide at `point`, about.
    double pixelSize(const glm::dvec3& point) const;

  private:
    glm::dvec3 _eye, _right, _up, _back;
    glm::dvec2 _size;
    double _focus; ///< pixels
    double _level, _ior;
};

} // namespace limpid::viewer
