#pragma once
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "scene/Mesh.h"

namespace limpid::reference {

/// What a mesh's materials let through (scene/Mesh.h, transmittance), with their textures.
class Sheets {
  public:
    Sheets() = default;
    explicit Sheets(const Mesh& mesh);

    /// Every face takes all light.
    bool none() const { return _materials.empty(); }
    /// Share of light that `face` lets through at `place`: weights of its second and third corner. [0, 1]
    glm::vec3 transmittance(const Mesh& mesh, std::uint32_t face, const glm::vec2& place) const;
    /// True where maps show the place (scene/Mesh.h, shownAlpha).
    bool isShown(const Mesh& mesh, std::uint32_t face, const glm::vec2& place) const;

  private:
    struct Place {
        glm::vec2 uv;
        glm::vec4 color; ///< linear RGB and alpha, [0, 1]
    };
    Place at(const Mesh& mesh, std::uint32_t face, const glm::vec2& place) const;
    std::vector<int> _materials; ///< of each face; empty if all are opaque
    bool _partly = false;        ///< of a mesh that is partly blended
};

} // namespace limpid::reference
