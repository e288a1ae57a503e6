#include "view/Visibility.h"

#include <algorithm>
#include <vector>

#include "core/Optics.h"

namespace limpid {

namespace {

using Points = std::vector<glm::dvec3>;

void addCorners(Points& points, const Bounds& bounds) {
    for (int i = 0; i < 8; ++i)
        points.push_back(bounds.corner(i));
}

/// Whether the hull of `points` may reach into the view: it does not where all of them are beyond one side,
/// or behind the camera. `scale` as viewClip of shaders/view/view.glsl has it.
bool mayBeSeen(const glm::dmat4& viewProjection, double scale, const Points& points) {
    double left = -1e300, right = -1e300, low = -1e300, high = -1e300, before = -1e300;
    for (const glm::dvec3& point : points) {
        glm::dvec4 clip = viewProjection * glm::dvec4(point, 1);
        clip.x *= scale, clip.y *= scale;
        // What single precision may turn in the shaders.
        const double slack = 1e-4 * (std::abs(clip.x) + std::abs(clip.y) + std::abs(clip.w));
        left = std::max(left, clip.w + clip.x + slack);
        right = std::max(right, clip.w - clip.x + slack);
        low = std::max(low, clip.w + clip.y + slack);
        high = std::max(high, clip.w - clip.y + slack);
        before = std::max(before, clip.w + slack);
    }
    return std::min({left, right, low, high, before}) >= 0;
}

/// Points whose hull holds every place of the surface where the camera sees something of the bounds, and what
/// of them lies on its own side. A ray crosses the surface between the feet of camera and point, no nearer to
/// the camera's than it does for the deepest point straight below.
Points seenThroughSurface(const ViewFrameData& frame, const Bounds& bounds) {
    Points points;
    const double plane = frame.viewWater.x, ior = frame.viewWater.y;
    const glm::dvec3 camera(frame.cameraPosition);
    Bounds above = bounds;
    above.min.y = std::max(above.min.y, plane);
    if (above.min.y <= above.max.y) addCorners(points, above);
    if (bounds.min.y >= plane) return points;
    const double height = std::max(camera.y - plane, 0.0);
    const double nearest = height / std::max(height + (plane - bounds.min.y) / ior, 1e-300);
    for (int i = 0; i < 4; ++i) {
        const glm::dvec3 corner(i & 1 ? bounds.max.x : bounds.min.x, plane,
                                i & 2 ? bounds.max.z : bounds.min.z);
        const glm::dvec3 foot(camera.x, plane, camera.z);
        points.push_back(corner);
        points.push_back(foot + nearest * (corner - foot));
    }
    return points;
}

} // namespace

bool mayShowCaustics(const ViewFrameData& frame, const Bounds& bounds) {
    const glm::dmat4 viewProjection(frame.viewProjection);
    if (frame.cameraAbove())
        return mayBeSeen(viewProjection, frame.viewWater.z, seenThroughSurface(frame, bounds));
    Points straight, mirrored;
    addCorners(straight, bounds);
    for (const glm::dvec3& point : straight)
        mirrored.emplace_back(point.x, 2 * frame.viewWater.x - point.y, point.z);
    return mayBeSeen(viewProjection, 1, straight) || mayBeSeen(viewProjection, frame.viewWater.z, mirrored);
}

} // namespace limpid
