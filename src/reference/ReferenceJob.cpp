#include "reference/ReferenceJob.h"

#include <embree3/rtcore_config.h>
#include <fmt/format.h>

#include "core/Error.h"
#include "core/Progress.h"
#include "plan/Plan.h"
#include "reference/FaceSorting.h"

namespace limpid::reference {

namespace {

io::Bake bakeOf(const TraceJob& job, TraceResult result) {
    io::Bake bake;
    bake.origin = job.origin;
    bake.time = job.time;
    bake.method = "reference";
    bake.device = fmt::format("CPU, Embree {}", RTC_VERSION_STRING);
    for (std::size_t i = 0; i < job.maps.size(); ++i) {
        const MapRequest& request = job.maps[i];
        TexelMap::Finished& finished = result.maps[i];
        io::BakedMap& map = bake.maps.emplace_back();
        map.receiver = job.scene.receivers[std::size_t(request.receiver)].name;
        map.light = job.scene.lights[std::size_t(request.light)].name;
        map.size = request.frame.size;
        map.facing = request.facing;
        map.irradiance = std::move(finished.irradiance);
        map.position = std::move(finished.position);
        map.normal = std::move(finished.normal);
        TexelFrame frame = request.frame;
        frame.box.corner -= job.origin;
        map.worldToTexture = frame.worldToTexture();
        map.deposited = finished.deposited;
        map.standardError = finished.standardError;
    }
    for (std::size_t i = 0; i < result.lights.size(); ++i) {
        const TracedLight& light = result.lights[i];
        bake.lights.push_back({job.scene.lights[i].name, light.photons, light.photons,
                               io::BakedFlux{light.entering,
                                             light.absorbed,
                                             light.scattered,
                                             light.deposited,
                                             light.missed,
                                             light.rejected,
                                             light.residual(),
                                             {}}});
    }
    return bake;
}

} // namespace

TraceJob referenceJob(const Scene& scene, double time) {
    for (const Receiver& receiver : scene.receivers)
        if (receiver.host)
            throw InputError(fmt::format("receiver \"{}\": expected triangles in memory, found a HostMesh",
                                         receiver.name));
    const Plan plan = planOf(scene);
    TraceJob job{scene, time, plan.origin, {}, {}, {}, {}};
    job.patchMin = plan.patch.min();
    job.patchSize = plan.patch.size;
    for (const PlannedLight& light : plan.lights)
        job.lightEnters.push_back(light.enters);
    for (const PlannedMap& map : plan.maps) {
        const int size = mapSize(scene, plan.patch, map.box, map.facing);
        job.maps.push_back(
            {map.receiver, map.light, map.facing, sortingOf(*map.facings), texelFrame(map.box, size)});
    }
    return job;
}

io::Bake traceBake(const TraceJob& job, TraceOptions how, const std::string& what, bool quiet) {
    constexpr int steps = 100;
    Progress progress(what, steps, !quiet);
    int shown = 0;
    how.progress = [&](int done, int total) {
        const int step = int(std::int64_t(steps) * done / total);
        if (step > shown) progress.update(step);
        shown = step;
    };
    return bakeOf(job, traceLight(job, how));
}

} // namespace limpid::reference
