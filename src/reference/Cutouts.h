#pragma once
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "scene/Mesh.h"

namespace limpid::reference {

/// The holes that materials cut into a mesh: alpha below the cutoff; of a blended surface, below a half.
class Cutouts {
  public:
    Cutouts() = default;
    explicit Cutouts(const Mesh& mesh);

    bool none() const { return _materials.empty(); }
    /// Whether `face` has a hole at `place`: weights of its second and third corner.
    bool at(const Mesh& mesh, std::uint32_t face, const glm::vec2& place) const;

  private:
    std::vector<int> _materials; ///< of each face; empty if no material has holes
};

} // namespace limpid::reference
