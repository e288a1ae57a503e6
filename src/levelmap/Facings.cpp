#include "levelmap/Facings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace limpid {

namespace {

struct Face {
    std::array<glm::dvec3, 3> corners;
    glm::dvec3 normal; ///< unit, by the winding
    double area;
};

/// Adds the face to the axis that it looks along, if it is steep.
void gather(Facings& facings, std::array<double, 4>& areas, const Face& face, const glm::dvec3& normal) {
    if (std::abs(glm::dot(normal, facings.light)) >= Facings::steep) return;
    std::size_t best = 0;
    for (std::size_t k = 1; k < 4; ++k)
        if (glm::dot(normal, facings.axes[k]) > glm::dot(normal, facings.axes[best])) best = k;
    areas[best] += face.area;
    facings.points[best].insert(facings.points[best].end(), face.corners.begin(), face.corners.end());
}

} // namespace

bool isClosed(const Mesh& mesh) {
    std::map<std::tuple<double, double, double>, int> places;
    std::vector<int> place;
    for (const glm::dvec3& p : mesh.positions)
        place.push_back(places.emplace(std::tuple(p.x, p.y, p.z), int(places.size())).first->second);
    std::map<std::pair<int, int>, int> open; // how often an edge is gone along, less how often against
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const int a = place[mesh.indices[i]], b = place[mesh.indices[i % 3 == 2 ? i - 2 : i + 1]];
        if (a < b) ++open[{a, b}];
        if (a > b) --open[{b, a}];
    }
    return std::all_of(open.begin(), open.end(), [](const auto& edge) { return edge.second == 0; });
}

Facings findFacings(const Receiver& receiver, const glm::dvec3& light, double level) {
    Facings facings;
    facings.light = glm::normalize(light);
    const glm::dvec3 helper = std::abs(facings.light.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1);
    const glm::dvec3 first = glm::normalize(helper - glm::dot(helper, facings.light) * facings.light);
    const glm::dvec3 second = glm::cross(facings.light, first);
    facings.axes = {first, second, -first, -second};
    const Mesh& mesh = *receiver.mesh;
    std::array<double, 4> areas{};
    double whole = 0, steep = 0;
    std::vector<Face> faces;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        Face face;
        for (std::size_t c = 0; c < 3; ++c)
            face.corners[c] = receiver.toWorld(mesh.positions[mesh.indices[i + c]]);
        const glm::dvec3 area =
            0.5 * glm::cross(face.corners[1] - face.corners[0], face.corners[2] - face.corners[0]);
        face.area = glm::length(area);
        if (!(face.area > 0) || std::min({face.corners[0].y, face.corners[1].y, face.corners[2].y}) >= level)
            continue;
        face.normal = area / face.area;
        whole += face.area;
        if (std::abs(glm::dot(face.normal, facings.light)) >= Facings::steep) continue;
        steep += face.area;
        faces.push_back(face);
    }
    const Bounds bounds = worldBounds(receiver);
    const bool cut = bounds.min.y < level && bounds.max.y > level;
    const bool further = steep >= Facings::fairShare * whole;
    if (!further && !cut) return facings;
    const bool mirrored = receiver.scale.x * receiver.scale.y * receiver.scale.z < 0;
    facings.sheet = mirrored || !isClosed(mesh);
    facings.hollow = cut && !facings.sheet;
    if (!further) return facings;
    for (const Face& face : faces) {
        gather(facings, areas, face, face.normal);
        if (facings.sheet) gather(facings, areas, face, -face.normal);
    }
    for (std::size_t k = 0; k < 4; ++k)
        facings.used[k] = areas[k] > Facings::fairShare * whole;
    return facings;
}

} // namespace limpid
