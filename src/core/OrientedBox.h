#pragma once
#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace limpid {

/// A box along the light: `u` × `w` = `t`, all unit, `t` the way the light travels. A point of the box is
/// corner + a·u + b·w + z·t with a in [0, extent.x], b in [0, extent.y], depth z in [0, extent.z], metres.
struct OrientedBox {
    glm::dvec3 corner{0};
    glm::dvec3 u{1, 0, 0}, w{0, 0, 1}, t{0, -1, 0};
    glm::dvec3 extent{0};

    /// (a, b, z) of a point.
    glm::dvec3 local(const glm::dvec3& p) const {
        const glm::dvec3 q = p - corner;
        return {glm::dot(q, u), glm::dot(q, w), glm::dot(q, t)};
    }
    glm::dvec3 point(const glm::dvec3& q) const { return corner + q.x * u + q.y * w + q.z * t; }
    glm::dvec3 center() const { return point(0.5 * extent); }
    bool operator==(const OrientedBox&) const = default;
};

/// The box around `points` with its depth along `direction` (unit) and the smallest footprint that any turn
/// about it gives (rotating calipers on the convex hull). Of the four turns with the same footprint, the one
/// whose `u` is nearest to +x. Thesis 4.2.1 with minimum and maximum in place of eq. 4-2, and the free choice
/// of U and W (eq. 4-1) put to use. `points` must not be empty.
OrientedBox tightBox(std::span<const glm::dvec3> points, const glm::dvec3& direction);

/// Convex hull, counter-clockwise, without collinear points; fewer than three for degenerate input.
std::vector<glm::dvec2> convexHull(std::vector<glm::dvec2> points);

/// A box cut into square texels: the frame of a receiver's maps. Row 0 is the top, u goes right, w goes down.
struct TexelFrame {
    OrientedBox box;    ///< footprint grown to whole texels
    glm::ivec2 size{0}; ///< texels
    double texel = 0;   ///< m, the side of one
    bool flat = false;  ///< the receiver had no height along the light: one plane holds all of it

    double texelArea() const { return texel * texel; }
    /// Column-major, from points of the world to [0,1]³.
    glm::dmat4 worldToTexture() const;
};

/// `mapSize` texels on the longer side of the box; the box is at least 1e-4 of that side thick.
TexelFrame texelFrame(const OrientedBox& tight, int mapSize);

} // namespace limpid
