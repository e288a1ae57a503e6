#include "plan/Facings.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "scene/HostMesh.h"
#include "scene/Places.h"

namespace limpid {

namespace {

struct Face {
    std::array<glm::dvec3, 3> corners;
    glm::dvec3 normal; ///< unit, by the winding
    double area;
};

/// The axis that a steep face looks along most.
std::size_t axisOf(const Facings& facings, const glm::dvec3& normal) {
    std::size_t best = 0;
    for (std::size_t k = 1; k < 4; ++k)
        if (glm::dot(normal, facings.axes[k]) > glm::dot(normal, facings.axes[best])) best = k;
    return best;
}

/// As facingOf in shaders/levelmap/facing.glsl: the map that holds a face.
int facingOf(const Facings& facings, const glm::dvec3& normal) {
    // Wider than there by what rounding may turn.
    if (std::abs(glm::dot(normal, facings.light)) >= Facings::steep) return 0;
    const std::size_t best = axisOf(facings, normal);
    return facings.used[best] ? int(best) + 1 : 0;
}

/// The triangles of the receiver in the world that are not wholly above `level`.
template <typename Visit>
void forEachFace(const Receiver& receiver, double level, const Visit& visit) {
    const Mesh& mesh = *receiver.mesh;
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
        visit(face);
    }
}

/// Whether faces are a host's, of which only their hull is known here. A flat hull is all that there is to
/// know.
bool isBeyondHull(const Receiver& receiver) {
    if (!receiver.host) return false;
    const glm::dvec3 size = receiver.host->bounds.size();
    return std::min({size.x, size.y, size.z}) > 0;
}

/// Faces may look along any axis, and lie anywhere in the hull.
void lookEveryWay(Facings& facings, const Receiver& receiver, double level) {
    facings.used.fill(true);
    forEachFace(receiver, level, [&](const Face& face) {
        for (std::vector<glm::dvec3>& points : facings.points)
            points.insert(points.end(), face.corners.begin(), face.corners.end());
    });
}

/// Adds the face to the axis that it looks along, if it is steep.
void gather(Facings& facings, std::array<double, 4>& areas, const Face& face, const glm::dvec3& normal) {
    if (std::abs(glm::dot(normal, facings.light)) >= Facings::steep) return;
    const std::size_t best = axisOf(facings, normal);
    areas[best] += face.area;
    facings.points[best].insert(facings.points[best].end(), face.corners.begin(), face.corners.end());
}

} // namespace

bool isClosed(const Mesh& mesh) {
    const auto places = placesOf(mesh.positions);
    struct Edge {
        std::uint32_t low, high;
        int way;
    };
    std::vector<Edge> edges;
    edges.reserve(mesh.indices.size());
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const auto a = places[mesh.indices[i]], b = places[mesh.indices[i % 3 == 2 ? i - 2 : i + 1]];
        if (a != b) edges.push_back({std::min(a, b), std::max(a, b), a < b ? 1 : -1});
    }
    const auto less = [](const Edge& a, const Edge& b) {
        return std::tie(a.low, a.high) < std::tie(b.low, b.high);
    };
    std::sort(edges.begin(), edges.end(), less);
    for (std::size_t i = 0; i < edges.size();) {
        int sum = 0;
        const std::size_t first = i;
        for (; i < edges.size() && !less(edges[first], edges[i]); ++i)
            sum += edges[i].way;
        if (sum != 0) return false;
    }
    return true;
}

bool enclosesSolid(const Receiver& receiver) {
    if (receiver.host) return receiver.host->closed;
    const auto cutOut = [](const Material& m) { return m.alphaMode != AlphaMode::Opaque; };
    const Mesh& mesh = *receiver.mesh;
    return std::none_of(mesh.materials.begin(), mesh.materials.end(), cutOut) && isClosed(mesh);
}

Facings findFacings(const Receiver& receiver, const glm::dvec3& light, double level, bool closed) {
    Facings facings;
    facings.light = glm::normalize(light);
    const glm::dvec3 helper = std::abs(facings.light.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1);
    const glm::dvec3 first = glm::normalize(helper - glm::dot(helper, facings.light) * facings.light);
    const glm::dvec3 second = glm::cross(facings.light, first);
    facings.axes = {first, second, -first, -second};
    std::array<double, 4> areas{};
    double whole = 0, steep = 0;
    std::vector<Face> faces;
    forEachFace(receiver, level, [&](const Face& face) {
        whole += face.area;
        if (std::abs(glm::dot(face.normal, facings.light)) >= Facings::steep) return;
        steep += face.area;
        faces.push_back(face);
    });
    if (isBeyondHull(receiver)) steep = receiver.host->walls ? whole : -1;
    const Bounds bounds = worldBounds(receiver);
    const bool cut = bounds.min.y < level && bounds.max.y > level;
    const bool further = steep >= Facings::fairShare * whole;
    if (!further && !cut) return facings;
    facings.sheet = !closed;
    facings.hollow = cut && !facings.sheet;
    if (!further) return facings;
    if (isBeyondHull(receiver)) {
        lookEveryWay(facings, receiver, level);
        return facings;
    }
    for (const Face& face : faces) {
        gather(facings, areas, face, face.normal);
        if (facings.sheet) gather(facings, areas, face, -face.normal);
    }
    for (std::size_t k = 0; k < 4; ++k)
        facings.used[k] = areas[k] > Facings::fairShare * whole;
    return facings;
}

DepthGradients depthGradients(const Receiver& receiver, const OrientedBox& box, const Facings& facings,
                              int facing, double level) {
    if (isBeyondHull(receiver)) return {glm::dvec2(0), glm::dvec2(-1e3), glm::dvec2(1e3)};
    DepthGradients gradients;
    glm::dvec2 least(1e300), most(-1e300), sum(0);
    double seen = 0;
    forEachFace(receiver, level, [&](const Face& face) {
        const bool held = facingOf(facings, face.normal) == facing ||
                          (facings.sheet && facingOf(facings, -face.normal) == facing);
        // What looks away counts too: of a sheet and of an open solid the map shows it turned round.
        const double along = -glm::dot(face.normal, box.t);
        if (!held || std::abs(along) < 1e-3) {
            // A face that runs along the box's axis may have any gradient where it shows at all.
            if (held) least = glm::min(least, glm::dvec2(-1e3)), most = glm::max(most, glm::dvec2(1e3));
            return;
        }
        const glm::dvec2 gradient =
            glm::dvec2(glm::dot(face.normal, box.u), glm::dot(face.normal, box.w)) / along;
        least = glm::min(least, gradient), most = glm::max(most, gradient);
        if (along <= 0 && !facings.sheet) return;
        sum += gradient * (face.area * std::abs(along));
        seen += face.area * std::abs(along);
    });
    if (!(seen > 0)) return gradients;
    gradients.mean = sum / seen;
    // The normal map holds 16 bits.
    const glm::dvec2 slack = glm::dvec2(1e-3) * (1.0 + glm::max(glm::abs(least), glm::abs(most)));
    gradients.least = least - slack, gradients.most = most + slack;
    return gradients;
}

} // namespace limpid
