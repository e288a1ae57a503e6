#include "plan/Sides.h"

namespace limpid {

std::vector<glm::dvec3> pointsOfSide(const Receiver& receiver, double level, Side side) {
    std::vector<glm::dvec3> world, kept;
    const Mesh& mesh = *receiver.mesh;
    for (const glm::dvec3& p : mesh.positions) {
        world.push_back(receiver.toWorld(p));
        if ((world.back().y <= level) == (side == Side::Below)) kept.push_back(world.back());
    }
    if (kept.empty() || kept.size() == world.size()) return kept;
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
        const glm::dvec3 &a = world[mesh.indices[i]], &b = world[mesh.indices[next]];
        if ((a.y <= level) == (b.y <= level)) continue;
        kept.push_back(a + (b - a) * ((level - a.y) / (b.y - a.y)));
    }
    return kept;
}

} // namespace limpid
