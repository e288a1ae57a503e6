#pragma once
#include <array>
#include <vector>

#include <glm/glm.hpp>

#include "core/OrientedBox.h"
#include "scene/Scene.h"

namespace limpid {

/// Faces that run along the mean light (pool walls under a high sun) have no texels in a map seen along it,
/// though waves throw light on them. They are gathered by where they look, in four directions across the
/// light; each that holds a fair share of the receiver gets a side map, seen half-way between light and
/// face.
struct Facings {
    /// Sine of the angle to the light below which a face is steep: 4°, about what waves bend light by.
    static constexpr double steep = 0.07;
    /// Share of a receiver's area from which a side map is made. A sphere has 0.03 each way and does
    /// without.
    static constexpr double fairShare = 0.05;

    glm::dvec3 light{0, -1, 0};       ///< mean light, unit
    std::array<glm::dvec3, 4> axes{}; ///< unit, across the light
    std::array<bool, 4> used{};       ///< whether axis k has a map
    bool hollow = false; ///< closed, and cut open by the water's surface: what shows of its inside is dark
    bool sheet = false;  ///< the mesh is not closed: light falls on both sides of its faces
    std::array<std::vector<glm::dvec3>, 4>
        points; ///< corners of the faces that look along axis k, in the world

    /// The way map k is seen: unit.
    glm::dvec3 viewDirection(int k) const { return glm::normalize(light - axes[std::size_t(k)]); }
    bool operator==(const Facings&) const = default;
};

/// How depth grows along a box's u and w on the faces that a map in it may hold, m/m. A plane has one
/// gradient; taken off, its depths are all the same, however it leans.
struct DepthGradients {
    glm::dvec2 mean{0}; ///< weighed by the area that is seen
    glm::dvec2 least{0}, most{0};
    bool operator==(const DepthGradients&) const = default;
};

/// Of the faces of the receiver that belong to map `facing` (0: along the light) and lie below `level`
/// somewhere.
DepthGradients depthGradients(const Receiver& receiver, const OrientedBox& box, const Facings& facings,
                              int facing, double level);

/// `light`: the mean light at the receiver; `level`: faces wholly above it do not count; `closed`: whether
/// the receiver is a solid (PlannedReceiver::solid).
Facings findFacings(const Receiver& receiver, const glm::dvec3& light, double level, bool closed);

/// Whether every edge of the mesh is shared by two triangles, once corners at one place count as one.
bool isClosed(const Mesh& mesh);

/// A receiver's mesh encloses a solid: it is closed and has no cut-outs. Its place and scale count for
/// nothing.
bool enclosesSolid(const Receiver& receiver);

} // namespace limpid
