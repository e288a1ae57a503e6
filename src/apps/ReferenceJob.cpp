#include "apps/ReferenceJob.h"

#include "levelmap/MapPlan.h"
#include "levelmap/ReceiverGeometry.h"
#include "water/FlatWater.h"

namespace limpid::apps {

namespace {

reference::FaceSorting sortingOf(const Facings& facings) {
    return {facings.light, Facings::steep, facings.axes, facings.used, facings.sheet};
}

} // namespace

reference::TraceJob referenceJob(const Scene& scene, double time) {
    reference::TraceJob job{scene, time, sceneOrigin(scene), {}, {}, {}, {}};
    const WaterPatch patch = coveringPatch(scene);
    job.patchMin = patch.min();
    job.patchSize = patch.size;
    for (const Light& light : scene.lights)
        job.lightEnters.push_back(entersWater(light, scene.water));
    std::vector<std::vector<glm::dvec3>> submerged;
    for (const Receiver& receiver : scene.receivers)
        submerged.push_back(pointsOfSide(receiver, scene.water.level, Side::Below));
    for (const PlannedMap& planned : planMaps(scene, submerged)) {
        const int size = mapSize(scene, patch, planned.box, planned.facing);
        job.maps.push_back({planned.receiver, planned.light, planned.facing, sortingOf(*planned.facings),
                            texelFrame(planned.box, size)});
    }
    return job;
}

} // namespace limpid::apps
