#include "view/ViewFrame.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>

#include "core/Optics.h"
#include "plan/WaveTerms.h"

namespace limpid {

namespace {

/// Nothing nearer than this is seen, m: a thousandth of the way to what the picture is about.
double nearPlane(const Bounds& bounds, const Camera& camera) {
    const double toScene =
        bounds.empty() ? 1e300
                       : glm::distance(*camera.position, bounds.center()) + glm::length(bounds.size());
    return 1e-3 * std::max(std::min(glm::distance(*camera.position, *camera.target), toScene), 1e-9);
}

/// y of the water's surface at a place, as it is drawn there (shaders/view/water_height.glsl), in the
/// world.
double surfaceHeight(const Water& water, const WaterPatch& patch, const WaterMesh& surface,
                     const glm::dvec3& origin, const glm::dvec2& xz) {
    const glm::dvec2 at = (xz - patch.min()) / patch.size * glm::dvec2(patch.grid);
    const glm::ivec2 quad(glm::floor(at));
    if (quad.x < 0 || quad.y < 0 || quad.x >= patch.grid.x || quad.y >= patch.grid.y) return water.level;
    // From the quad's first corner to its last.
    const auto row = std::size_t(patch.grid.x + 1);
    const std::vector<glm::vec4> vertices =
        surface.positions.read<glm::vec4>(row + 2, std::size_t(quad.y) * row + std::size_t(quad.x));
    const auto corner = [&](int right, int down) {
        const glm::ivec2 c = quad + glm::ivec2(right, down);
        const double height = double(vertices[std::size_t(down) * row + std::size_t(right)].y) + origin.y;
        const float share = shader::rimShare(glm::vec2(c) / glm::vec2(patch.grid));
        return float(glm::mix(water.level, height, double(share)) - water.level);
    };
    return water.level +
           double(shader::quadHeight((quad.x + quad.y) % 2 == 0, glm::vec2(at - glm::dvec2(quad)),
                                     corner(0, 0), corner(1, 0), corner(0, 1), corner(1, 1)));
}

/// Where the camera is with respect to the water.
struct Eye {
    glm::dvec3 position; ///< in the world, never in the surface itself
    bool above;
    double plane; ///< y of the flat surface that views through and in the water are made by
};

Eye eyeOf(const Camera& camera, const Water& water, double near, double height) {
    Eye eye{*camera.position, camera.position->y >= height, water.level};
    // In the surface, half of the rays would start on its other side.
    const double least = 0.1 * near;
    if (eye.above) {
        eye.position.y = std::max(eye.position.y, height + least);
        eye.plane = std::min(eye.plane, eye.position.y - least);
    } else {
        eye.position.y = std::min(eye.position.y, height - least);
        eye.plane = std::max(eye.plane, eye.position.y + least);
    }
    return eye;
}

/// An upper bound on metres beyond the surface between the camera's rays and any receiver. Waves bend rays
/// further than flat water does; a quarter more has room for it.
double farthestSeen(const Bounds& bounds, const Water& water, const Eye& eye) {
    double farthest = 1e-6;
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 corner = bounds.corner(i);
        if (!eye.above) {
            farthest = std::max(farthest, glm::distance(corner, eye.position));
            continue;
        }
        const double above = eye.position.y - eye.plane, below = std::max(eye.plane - corner.y, 0.0);
        const double across =
            glm::distance(glm::dvec2(eye.position.x, eye.position.z), glm::dvec2(corner.x, corner.z));
        const double rest = across - optics::flatCrossing(above, below, across, water.ior);
        farthest = std::max(farthest, std::hypot(rest, below));
    }
    return 1.25 * farthest;
}

/// Radiance of endless water in which the ambient light is the same everywhere: what each metre scatters into
/// a ray balances what extinction takes from it.
glm::dvec3 deepRadiance(const Scene& scene) {
    glm::dvec3 deep = scene.ambientRadiance;
    for (int c = 0; c < 3; ++c) {
        const double lost = scene.water.absorption[c] + scene.water.scattering[c];
        if (lost > 0) deep[c] *= scene.water.scattering[c] / lost;
    }
    return deep;
}

glm::dmat4 viewProjection(const Camera& camera, const glm::dvec3& position, double near, glm::ivec2 size) {
    // Depth is near / distance: 1 at the near plane, 0 far away. Floats are as fine near 0 as depths are
    // close together there, so that a tenth of a millimetre counts at any distance.
    const double focus = 1 / std::tan(0.5 * glm::radians(camera.verticalFov));
    glm::dmat4 projection(0);
    projection[0][0] = focus * size.y / size.x;
    projection[1][1] = focus;
    projection[2][3] = -1;
    projection[3][2] = near;
    const glm::dvec3 way = *camera.target - *camera.position;
    // Looking along `up`, any other axis serves.
    const bool vertical = glm::length(glm::cross(glm::normalize(way), glm::normalize(camera.up))) < 1e-6;
    return projection * glm::lookAt(position, position + way, vertical ? glm::dvec3(0, 0, -1) : camera.up);
}

void setBounds(glm::vec4& min, glm::vec4& max, const Bounds& bounds, const glm::dvec3& origin) {
    if (bounds.empty()) {
        min = max = glm::vec4(0);
        return;
    }
    // A ray is followed to the end of the box, which must not lie in the faces that it is to meet.
    const double margin = 0.01 * std::max(glm::length(bounds.size()), 1e-6);
    min = glm::vec4(bounds.min - margin - origin, 1);
    max = glm::vec4(bounds.max + margin - origin, 0);
}

/// Both sides reach as far as waves lay them bare or cover them.
void setSides(ViewFrameData& frame, SideBounds sides, const Water& water, const glm::dvec3& origin) {
    sides.dry.min.y = std::min(sides.dry.min.y, water.level - highestWave(water));
    sides.wet.max.y = std::max(sides.wet.max.y, water.level + highestWave(water));
    const bool above = frame.cameraAbove();
    setBounds(frame.nearSideMin, frame.nearSideMax, above ? sides.dry : sides.wet, origin);
    setBounds(frame.farSideMin, frame.farSideMax, above ? sides.wet : sides.dry, origin);
}

} // namespace

double heightAtCamera(const Scene& scene, const glm::dvec3& origin, const WaterPatch& patch,
                      const WaterMesh& surface) {
    const glm::dvec3& camera = *scene.camera.position;
    if (std::abs(camera.y - scene.water.level) > highestWave(scene.water)) return scene.water.level;
    return surfaceHeight(scene.water, patch, surface, origin, {camera.x, camera.z});
}

ViewFrameData viewFrame(const Scene& scene, const glm::dvec3& origin, const WaterPatch& patch,
                        const SideBounds& sides, double waterHeight, glm::ivec2 samples) {
    const Camera& camera = scene.camera;
    const Water& water = scene.water;
    const Bounds bounds = worldBounds(scene);
    const double near = nearPlane(bounds, camera);
    const Eye eye = eyeOf(camera, water, near, waterHeight);
    ViewFrameData frame;
    frame.viewProjection = viewProjection(camera, eye.position - origin, near, samples);
    frame.cameraPosition = glm::vec4(eye.position - origin, eye.above ? 1 : 0);
    frame.ambientRadiance = glm::vec4(scene.ambientRadiance, 0);
    frame.skyRadiance = glm::vec4(scene.skyRadiance, 0);
    frame.waterExtinction = glm::vec4(water.absorption + water.scattering, farthestSeen(bounds, water, eye));
    const double texel = 2 * std::tan(0.5 * glm::radians(camera.verticalFov)) / samples.y;
    frame.viewWater = glm::vec4(eye.plane - origin.y, water.ior, 1 / (1 + viewMargin), texel);
    frame.deepRadiance = glm::vec4(deepRadiance(scene), 0);
    frame.waterRest = glm::vec4(water.level - origin.y, 0, 0, 0);
    frame.patchRect = rectOf(patch, origin);
    frame.patchQuads = glm::ivec4(patch.grid, 0, 0);
    setSides(frame, sides, water, origin);
    return frame;
}

} // namespace limpid
