#include "plan/Shading.h"

#include <algorithm>

namespace limpid {

namespace {

/// What maps ask about a receiver's rim lies beside it by a few texels; 16 is the least that a map has.
constexpr double margin = 1.0 / 8;

Bounds grown(const Bounds& box) {
    const glm::dvec3 by(margin * glm::length(box.size()));
    return {box.min - by, box.max + by};
}

} // namespace

/// The hull is all boxes a + t (b - a), t in [0, 1]; each axis leaves a stretch of t.
bool meetsHull(const Bounds& box, const Bounds& a, const Bounds& b) {
    double first = 0, last = 1;
    // Keeps the t where from + t · (to - from) <= most.
    const auto cut = [&](double from, double to, double most) {
        const double rise = to - from;
        if (rise > 0)
            last = std::min(last, (most - from) / rise);
        else if (rise < 0)
            first = std::max(first, (most - from) / rise);
        else if (from > most)
            last = -1;
    };
    for (int axis = 0; axis < 3; ++axis) {
        cut(a.min[axis], b.min[axis], box.max[axis]);
        cut(-a.max[axis], -b.max[axis], -box.min[axis]);
    }
    return first <= last;
}

std::vector<int> mayShade(const Scene& scene, const Plan& plan, const PlannedMap& map) {
    const Bounds& wet = plan.receivers[std::size_t(map.receiver)].wet;
    const Bounds entries = entriesTo(scene.water, scene.lights[std::size_t(map.light)], grown(wet));
    std::vector<int> found;
    for (int i = 0; i < int(plan.receivers.size()); ++i) {
        const Bounds& own = plan.receivers[std::size_t(i)].bounds;
        const Bounds bounds{own.min + plan.origin, own.max + plan.origin};
        if (i == map.receiver || (!entries.empty() && meetsHull(bounds, grown(wet), entries)))
            found.push_back(i);
    }
    return found;
}

} // namespace limpid
