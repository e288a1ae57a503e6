#include "io/toml/SceneSettings.h"

#include <fmt/format.h>

#include "scene/Keys.h"
#include "scene/WaterBodies.h"

namespace limpid::io {

namespace {

/// The keys of one table that are plain members.
template <typename S>
void add(std::vector<Setting>& settings, const char* section, int entry, std::span<const Key<S>> keys,
         const S& object) {
    for (const Key<S>& key : keys)
        if (knows(object, key))
            if (std::string value = tomlOf(key, object); !value.empty())
                settings.push_back({section, entry, std::string(key.name), std::move(value)});
}

/// Water that is a named one says that in place of what it stands for.
void addWater(std::vector<Setting>& settings, const Water& water) {
    add(settings, "water", -1, waterKeys, water);
    const auto body = waterBodyOf(water);
    if (!body) return;
    std::erase_if(settings, [](const Setting& setting) {
        return setting.section == "water" &&
               (setting.key == "absorption" || setting.key == "scattering" || setting.key == "anisotropy");
    });
    settings.push_back({"water", -1, "type", fmt::format("\"{}\"", waterBodies[*body])});
}

} // namespace

std::vector<Setting> settingsOf(const Wave& wave, int entry) {
    std::vector<Setting> settings;
    add(settings, "water.wave", entry, waveKeys, wave);
    if (wave.type == WaveType::HeightMap)
        std::erase_if(settings, [](const Setting& setting) { return setting.key != "amplitude"; });
    return settings;
}

std::vector<Setting> settingsOf(const Scene& scene) {
    std::vector<Setting> all;
    add(all, "camera", -1, cameraKeys, scene.camera);
    addWater(all, scene.water);
    for (std::size_t i = 0; i < scene.water.waves.size(); ++i)
        for (Setting& setting : settingsOf(scene.water.waves[i], int(i)))
            all.push_back(std::move(setting));
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        add(all, "light", int(i), lightKeys, scene.lights[i]);
    for (std::size_t i = 0; i < scene.receivers.size(); ++i)
        add(all, "receiver", int(i), receiverKeys, scene.receivers[i]);
    add(all, "sky", -1, skyKeys, scene);
    add(all, "ambient", -1, ambientKeys, scene);
    add(all, "caustics", -1, causticsKeys, scene.caustics);
    add(all, "godrays", -1, godrayKeys, scene.godrays);
    return all;
}

} // namespace limpid::io
