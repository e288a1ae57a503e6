#include "apps/GroundTruth.h"

#include <fmt/format.h>

#include "core/Error.h"
#include "scene/Fingerprint.h"

namespace limpid::apps {

bool canTraceGroundTruth() {
    return false;
}

GroundTruth::GroundTruth(std::filesystem::path folder, std::int64_t photons, double time, bool quiet)
    : _folder(std::move(folder)), _photons(photons), _time(time), _quiet(quiet) {}

const io::Bake& GroundTruth::maps(const Scene& scene) {
    std::string names;
    for (const Receiver& receiver : scene.receivers)
        names += receiver.name + (&receiver == &scene.receivers.back() ? "" : "+");
    const std::string key = fmt::format("{:.60}-{}-{}-{}-{:016x}", names, scene.caustics.mapSize, _photons,
                                        _time, lightFingerprint(scene));
    if (key == _key) return _maps;
    const std::filesystem::path kept = _folder / key;
    if (!std::filesystem::exists(kept / "index.json"))
        throw InputError(
            fmt::format("{}: expected a build with LIMPID_REFERENCE, found none", kept.string()));
    _maps = io::readBake(kept);
    _key = key;
    return _maps;
}

} // namespace limpid::apps
