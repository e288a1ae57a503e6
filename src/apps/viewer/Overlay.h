#pragma once
#include <functional>
#include <utility>

#include <imgui.h>

#include "apps/viewer/Keys.h"

namespace limpid::viewer {

/// Lines of the scene over its picture, bent where the water refracts what is seen of them. Nothing else is
/// drawn beyond the picture's edges as long as this lives.
class Overlay {
  public:
    Overlay(const Scene& scene, const Area& picture);
    ~Overlay();
    Overlay(const Overlay&) = delete;
    Overlay& operator=(const Overlay&) = delete;

    const Projection& projection() const { return _projection; }

    void line(const glm::dvec3& from, const glm::dvec3& to, ImU32 color) const;
    /// `point`: in the world, from 0 to 1. Returns the last piece's ends, pixels of the window; none if it is
    /// not seen.
    std::optional<std::pair<ImVec2, ImVec2>> curve(const std::function<glm::dvec3(double)>& point, int pieces,
                                                   ImU32 color, float width) const;

  private:
    Projection _projection;
    glm::dvec2 _corner;
};

} // namespace limpid::viewer
