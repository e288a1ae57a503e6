#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "core/Bounds.h"
#include "scene/Mesh.h"

namespace limpid {

/// The cells of a box that triangles pass through: `side` a side, with one layer of empty cells all around.
/// No path from cell to cell across faces leads through a triangle.
class Voxels {
  public:
    static constexpr int side = 96;
    static constexpr int count = side + 2; ///< along each axis, the empty layers included

    /// `box`: m, has volume.
    explicit Voxels(const Bounds& box) : _box(box), _solid(std::size_t(count) * count * count, false) {}

    /// Marks the cells of a triangle that lies in the box.
    void add(const std::array<glm::dvec3, 3>& triangle);

    bool solid(std::size_t cell) const { return _solid[cell]; }
    static std::size_t index(const glm::ivec3& at) {
        return (std::size_t(at.y) * count + std::size_t(at.z)) * count + std::size_t(at.x);
    }
    static glm::ivec3 place(std::size_t cell) {
        return {int(cell % count), int(cell / (std::size_t(count) * count)), int(cell / count % count)};
    }
    /// The lower corner of a cell, m.
    glm::dvec3 corner(const glm::ivec3& at) const {
        return _box.min + _box.size() * (glm::dvec3(at) - 1.0) / double(side);
    }

  private:
    Bounds _box;
    std::vector<bool> _solid;
};

} // namespace limpid
