#include "plan/Plan.h"

#include <algorithm>

#include "plan/PointLightPatch.h"

namespace limpid {

namespace {

/// Whether a receiver's own triangles enclose a solid, by those that have the same.
std::optional<bool> closedAmong(std::span<const PlannedReceiver> receivers, const Receiver& receiver) {
    const auto same = std::find_if(receivers.begin(), receivers.end(), [&](const PlannedReceiver& other) {
        return other.mesh == receiver.mesh && other.host == receiver.host;
    });
    return same == receivers.end() ? std::nullopt : std::optional<bool>(same->closed);
}

bool isMirrored(const Receiver& receiver) {
    return receiver.scale.x * receiver.scale.y * receiver.scale.z < 0;
}

PlannedReceiver planReceiver(const Receiver& receiver, bool closed, double level, const glm::dvec3& origin) {
    PlannedReceiver plan;
    plan.mesh = receiver.mesh;
    plan.host = receiver.host;
    plan.closed = closed;
    plan.solid = closed && !isMirrored(receiver);
    const Bounds bounds = worldBounds(receiver);
    plan.bounds = {bounds.min - origin, bounds.max - origin};
    plan.submerged = pointsOfSide(receiver, level, Side::Below);
    for (const glm::dvec3& p : plan.submerged)
        plan.wet.add(p);
    return plan;
}

void planSides(Plan& plan, const Scene& scene) {
    for (const Receiver& receiver : scene.receivers) {
        const std::vector<glm::dvec3> above = pointsOfSide(receiver, scene.water.level, Side::Above);
        plan.dry.insert(plan.dry.end(), above.begin(), above.end());
    }
    for (const glm::dvec3& p : plan.dry)
        plan.sides.dry.add(p);
    for (const PlannedReceiver& receiver : plan.receivers)
        for (const glm::dvec3& p : receiver.submerged)
            plan.sides.wet.add(p);
}

double farthestWater(const Light& light, const Water& water, const std::vector<glm::dvec3>& points) {
    double farthest = 1e-6;
    for (const glm::dvec3& p : points)
        farthest = std::max(farthest, glm::distance(p, entryPoint(light, water, p)));
    return 1.02 * farthest;
}

PlannedLight planLight(const Light& light, const Water& water, const Plan& plan) {
    PlannedLight planned;
    planned.enters = entersWater(light, water);
    planned.frame = lightFrame(light, water, plan.origin);
    if (planned.enters) {
        std::vector<glm::dvec3> points;
        for (const PlannedReceiver& receiver : plan.receivers)
            points.insert(points.end(), receiver.submerged.begin(), receiver.submerged.end());
        planned.frame.sceneDepthRect = sceneDepthRect(light, water, points, plan.origin);
        planned.farthest = farthestWater(light, water, points);
    }
    planned.pointLightPatch = pointLightPatch(light, water, plan.patch);
    planned.frame.surfaceShadowRect = surfaceShadowRect(light, water, plan.patch, plan.dry, plan.origin);
    return planned;
}

} // namespace

Plan planOf(const Scene& scene, std::span<const PlannedReceiver> before) {
    Plan plan;
    plan.origin = sceneOrigin(scene);
    plan.patch = coveringPatch(scene);
    for (const Receiver& receiver : scene.receivers) {
        std::optional<bool> closed = closedAmong(before, receiver);
        if (!closed) closed = closedAmong(plan.receivers, receiver);
        if (!closed) closed = enclosesSolid(receiver);
        plan.receivers.push_back(planReceiver(receiver, *closed, scene.water.level, plan.origin));
    }
    planSides(plan, scene);
    for (const Light& light : scene.lights)
        plan.lights.push_back(planLight(light, scene.water, plan));
    plan.maps = planMaps(scene, plan.receivers, plan.patch);
    return plan;
}

} // namespace limpid
