#include "apps/profile/GroundTruth.h"

#include <fmt/format.h>

#include "scene/Fingerprint.h"
#ifdef LIMPID_WITH_REFERENCE
#include "reference/ReferenceJob.h"
#endif

namespace limpid::apps {

GroundTruth::GroundTruth(std::filesystem::path folder, std::int64_t photons, double time, bool quiet)
    : _folder(std::move(folder)), _photons(photons), _time(time), _quiet(quiet) {}

const io::Bake& GroundTruth::maps(const Scene& scene) {
    const std::string key = keyOf(scene);
    if (key == _key) return _maps;
    const std::filesystem::path kept = _folder / key;
    if (std::filesystem::exists(kept / "index.json")) {
        _maps = io::readBake(kept);
    } else {
        _maps = trace(scene);
        io::writeBake(kept, _maps);
    }
    _key = key;
    return _maps;
}

std::string GroundTruth::keyOf(const Scene& scene) {
    const std::uint64_t light = lightFingerprint(scene);
    std::string& key = _keys[{light, scene.caustics.mapSize, scene.water.grid.x, scene.water.grid.y}];
    if (key.empty())
        key = fmt::format("{:.60}-{}-{}-{}-{:016x}", receiverNames(scene), scene.caustics.mapSize, _photons,
                          _time, light ^ sizesOf(scene));
    return key;
}

#ifdef LIMPID_WITH_REFERENCE

bool canTraceGroundTruth() {
    return true;
}

std::uint64_t GroundTruth::sizesOf(const Scene& scene) const {
    std::uint64_t sizes = 0;
    for (const reference::MapRequest& map : reference::referenceJob(scene, _time).maps)
        sizes = (sizes * 65599 + std::uint64_t(map.frame.size.x)) * 65599 + std::uint64_t(map.frame.size.y);
    return sizes;
}

io::Bake GroundTruth::trace(const Scene& scene) const {
    reference::TraceOptions how;
    how.photons = _photons;
    return reference::traceBake(reference::referenceJob(scene, _time), how,
                                fmt::format("light traced for {}, percent", receiverNames(scene)), _quiet);
}

#else

bool canTraceGroundTruth() {
    return false;
}

std::uint64_t GroundTruth::sizesOf(const Scene&) const {
    return 0;
}

io::Bake GroundTruth::trace(const Scene&) const {
    return {};
}

#endif

} // namespace limpid::apps
