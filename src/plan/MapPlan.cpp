#include "plan/MapPlan.h"

#include <algorithm>

#include "plan/FlatWater.h"

namespace limpid {

namespace {

/// The map along the light, and one for each way that faces along the light look.
void planReceiver(std::vector<PlannedMap>& plan, const Scene& scene, int receiver, int light,
                  const PlannedReceiver& planned) {
    const std::vector<glm::dvec3>& submerged = planned.submerged;
    const glm::dvec3 direction =
        meanDirection(scene.lights[std::size_t(light)], scene.water, planned.wet.center());
    const auto facings = std::make_shared<const Facings>(
        findFacings(scene.receivers[std::size_t(receiver)], direction, scene.water.level, planned.solid));
    plan.push_back({receiver, light, 0, facings, tightBox(submerged, facings->light), {}, true});
    for (int k = 0; k < 4; ++k)
        if (facings->used[std::size_t(k)])
            plan.push_back({receiver,
                            light,
                            k + 1,
                            facings,
                            tightBox(facings->points[std::size_t(k)], facings->viewDirection(k)),
                            {},
                            true});
}

} // namespace

bool PlannedMap::operator==(const PlannedMap& other) const {
    return receiver == other.receiver && light == other.light && facing == other.facing && box == other.box &&
           gradients == other.gradients && inReach == other.inReach &&
           (facings == other.facings || *facings == *other.facings);
}

std::vector<PlannedMap> planMaps(const Scene& scene, std::span<const PlannedReceiver> receivers,
                                 const WaterPatch& patch) {
    std::vector<PlannedMap> plan;
    for (std::size_t light = 0; light < scene.lights.size(); ++light)
        for (std::size_t receiver = 0; receiver < scene.receivers.size(); ++receiver)
            if (!receivers[receiver].submerged.empty())
                planReceiver(plan, scene, int(receiver), int(light), receivers[receiver]);
    for (PlannedMap& map : plan) {
        const auto receiver = std::size_t(map.receiver);
        map.gradients =
            depthGradients(scene.receivers[receiver], map.box, *map.facings, map.facing, scene.water.level);
        map.inReach =
            mayReach(scene.water, scene.lights[std::size_t(map.light)], receivers[receiver].wet, patch);
    }
    return plan;
}

int mapSize(const Scene& scene, const WaterPatch& patch, const OrientedBox& box, int facing) {
    const int asked = scene.caustics.mapSize;
    if (facing == 0) return asked;
    const glm::dvec2 quad = patch.size / glm::dvec2(patch.grid);
    const double longer = std::max(box.extent.x, box.extent.y);
    return int(std::clamp(std::ceil(4 * longer / std::min(quad.x, quad.y)), 1.0, double(asked)));
}

glm::dvec3 sceneOrigin(const Scene& scene) {
    const Bounds bounds = worldBounds(scene);
    if (bounds.empty()) return glm::dvec3(0);
    // Float positions keep micrometres within a few hundred sizes of the scene from zero; beyond, they are
    // counted from its middle.
    const double size = std::max(glm::length(bounds.size()), 1e-9);
    return glm::length(bounds.center()) > 16 * size ? glm::round(bounds.center()) : glm::dvec3(0);
}

} // namespace limpid
