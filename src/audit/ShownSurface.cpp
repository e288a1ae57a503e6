#include "audit/ShownSurface.h"

#include <cmath>

#include "reference/TexelMap.h"

namespace limpid {

namespace {

glm::dvec3 tripleOf(std::span<const float> numbers, std::size_t i) {
    return {numbers[i], numbers[i + 1], numbers[i + 2]};
}

} // namespace

bool ShownSurface::isSeen(const glm::dvec3& local, double depth,
                          const reference::SceneGeometry& geometry) const {
    const double before = 0.01 * frame.box.extent.z;
    const reference::Hit seen = geometry.firstShown(receiver, frame.box.point({local.x, local.y, -before}),
                                                    frame.box.t, level, faces, facing);
    return seen && std::abs(seen.distance - before - depth) <= 0.5 * frame.texel;
}

double ShownSurface::share(const reference::Hit& hit, const reference::SceneGeometry& geometry) const {
    const OrientedBox& box = frame.box;
    const glm::dvec3 q = box.local(hit.point);
    const glm::dvec2 place = glm::dvec2(q) / frame.texel;
    // Not floor: a place far outside must not overflow an int.
    if (!(place.x >= 0 && place.y >= 0 && place.x < frame.size.x && place.y < frame.size.y)) return 0;
    const glm::ivec2 texel(place);
    const std::size_t i = std::size_t(texel.y) * std::size_t(frame.size.x) + std::size_t(texel.x);
    if (position[4 * i + 3] == 0) return 0;
    const double depth = box.local(tripleOf(position, 4 * i)).z;
    const reference::TexelFace face{glm::dvec2(texel) + 0.5, depth,
                                    reference::depthGradient(tripleOf(normal, 3 * i), box)};
    if (!face.goesOn(place, q.z, {reference::depthGradient(hit.normal, box)}, frame.texel)) return 0;
    if (coverage[i] < 1 && !isSeen(q, q.z, geometry)) return 0;
    return taken.empty() ? 1.0 : double(taken[i]);
}

} // namespace limpid
