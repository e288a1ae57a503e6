#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "core/ShaderData.h"

namespace limpid {

/// A box along the axes in single precision, m; empty (low > high) until something is added.
struct Box3f {
    glm::vec3 low{1e30f};
    glm::vec3 high{-1e30f};

    void add(const glm::vec3& p) { low = glm::min(low, p), high = glm::max(high, p); }
    void add(const Box3f& b) { low = glm::min(low, b.low), high = glm::max(high, b.high); }
    /// Half the surface, m².
    float halfArea() const;
};

/// A node of a bounding volume hierarchy in depth-first order: its first child is the node behind it, and a
/// traversal that misses it goes on at `next`, so none needs a stack. `items` of a leaf: 8 · (first of
/// `order`)
/// + count, count in [1, 4].
using BvhNode = gpu::OccluderNode;

struct Bvh {
    std::vector<BvhNode> nodes;       ///< empty for no boxes
    std::vector<std::uint32_t> order; ///< of the boxes: leaves hold runs of it
};

/// Binned surface area heuristic (Wald 2007), at most 4 boxes a leaf. O(n log n); boxes must be finite.
Bvh buildBvh(std::span<const Box3f> boxes);

} // namespace limpid
