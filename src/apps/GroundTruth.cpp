#include "apps/GroundTruth.h"

#include <functional>

#include <fmt/format.h>

#include "scene/Fingerprint.h"
#ifdef LIMPID_WITH_REFERENCE
#include "apps/ReferenceJob.h"
#endif

namespace limpid::apps {

namespace {

/// The maps that are to be traced, and how to trace them: nothing in a build without a tracer.
struct Job {
    std::uint64_t sizes = 0; ///< a number that differs with the maps' sizes
    std::function<io::Bake()> trace;
};

#ifdef LIMPID_WITH_REFERENCE

Job jobOf(const Scene& scene, double time, std::int64_t photons, const std::string& name, bool quiet) {
    const auto job = std::make_shared<const reference::TraceJob>(referenceJob(scene, time));
    std::uint64_t sizes = 0;
    for (const reference::MapRequest& map : job->maps)
        sizes = (sizes * 65599 + std::uint64_t(map.frame.size.x)) * 65599 + std::uint64_t(map.frame.size.y);
    return {sizes, [=] {
                reference::TraceOptions how;
                how.photons = photons;
                return traceBake(*job, how, fmt::format("light traced for {}, percent", name), quiet);
            }};
}

#else

Job jobOf(const Scene&, double, std::int64_t, const std::string&, bool) {
    return {};
}

#endif

} // namespace

bool canTraceGroundTruth() {
#ifdef LIMPID_WITH_REFERENCE
    return true;
#else
    return false;
#endif
}

GroundTruth::GroundTruth(std::filesystem::path folder, std::int64_t photons, double time, bool quiet)
    : _folder(std::move(folder)), _photons(photons), _time(time), _quiet(quiet) {}

const io::Bake& GroundTruth::maps(const Scene& scene) {
    std::string names;
    for (const Receiver& receiver : scene.receivers)
        names += receiver.name + (&receiver == &scene.receivers.back() ? "" : "+");
    // Sizes of further maps depend on the water's grid.
    const Job job = jobOf(scene, _time, _photons, names, _quiet);
    const std::string key = fmt::format("{:.60}-{}-{}-{}-{:016x}", names, scene.caustics.mapSize, _photons,
                                        _time, lightFingerprint(scene) ^ job.sizes);
    if (key == _key) return _maps;
    const std::filesystem::path kept = _folder / key;
    if (std::filesystem::exists(kept / "index.json")) {
        _maps = io::readBake(kept);
    } else {
        _maps = job.trace();
        io::writeBake(kept, _maps);
    }
    _key = key;
    return _maps;
}

} // namespace limpid::apps
