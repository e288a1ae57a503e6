#include "apps/profile/GodrayTruth.h"

#include <fmt/format.h>

#ifdef LIMPID_WITH_REFERENCE
#include <nlohmann/json.hpp>

#include "io/Files.h"
#include "io/images/Images.h"
#include "plan/FlatWater.h"
#include "plan/MapPlan.h"
#include "reference/Scattering.h"
#include "scene/Fingerprint.h"
#endif

namespace limpid::apps {

#ifdef LIMPID_WITH_REFERENCE

namespace {

namespace fs = std::filesystem;

/// Changes with what the camera sees and what the water scatters.
std::uint64_t viewFingerprint(const Scene& scene) {
    const Camera& camera = scene.camera;
    Hash hash;
    hash(*camera.position, *camera.target, camera.up, camera.verticalFov, scene.water.scattering,
         scene.water.anisotropy);
    return hash.value();
}

ScatteredPicture readKept(const fs::path& kept) {
    ScatteredPicture picture;
    picture.rgb = io::readImage(kept / "radiance.exr").data;
    const std::vector<std::uint8_t> text = io::readBytes(kept / "index.json");
    picture.standardError = nlohmann::json::parse(text)["standard_error"];
    return picture;
}

ScatteredPicture traced(const Scene& scene, double time, std::int64_t photons, glm::ivec2 size) {
    const glm::dvec3 origin = sceneOrigin(scene);
    const WaterPatch patch = coveringPatch(scene);
    const reference::ScatterImage image =
        reference::scatteredLight(reference::scatterView(scene.camera, origin, size),
                                  {scene, time, origin, patch.min(), patch.size, photons, 1, 0});
    ScatteredPicture picture;
    picture.standardError = image.standardError;
    for (const glm::dvec3& pixel : image.radiance)
        for (int c = 0; c < 3; ++c)
            picture.rgb.push_back(float(pixel[c]));
    return picture;
}

} // namespace

std::optional<ScatteredPicture> scatteredPicture(const fs::path& folder, const std::string& name,
                                                 const Scene& scene, double time, std::int64_t photons,
                                                 glm::ivec2 size) {
    const fs::path kept =
        folder / fmt::format("{:.60}-godrays-{}x{}-{}-{}-{:016x}", name, size.x, size.y, photons, time,
                             lightFingerprint(scene) ^ viewFingerprint(scene));
    if (fs::exists(kept / "index.json")) return readKept(kept);
    ScatteredPicture picture = traced(scene, time, photons, size);
    fs::create_directories(kept);
    io::writeExr(kept / "radiance.exr", size.x, size.y, {"R", "G", "B"}, picture.rgb);
    const nlohmann::json index = {{"limpid", LIMPID_VERSION},
                                  {"radiance", "radiance.exr"},
                                  {"photons", photons},
                                  {"time", time},
                                  {"standard_error", picture.standardError}};
    io::writeText(kept / "index.json", index.dump(1) + "\n");
    return picture;
}

#else

std::optional<ScatteredPicture> scatteredPicture(const std::filesystem::path&, const std::string&,
                                                 const Scene&, double, std::int64_t, glm::ivec2) {
    return std::nullopt;
}

#endif

} // namespace limpid::apps
