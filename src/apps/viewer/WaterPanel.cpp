#include "apps/viewer/WaterPanel.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "apps/viewer/Widgets.h"
#include "scene/Sea.h"
#include "scene/WaterBodies.h"
#include "scene/WaterPresets.h"

namespace limpid::viewer {

using namespace widgets;

namespace {

constexpr Field perMetre{.speed = 0.002, .min = 0, .max = 1e12, .format = "%.3g"};

void patchFields(Water& water, double speed) {
    bool own = water.size.has_value();
    if (ImGui::Checkbox("a patch of its own", &own)) {
        if (own) water.size = glm::dvec2(2), water.center = water.center.value_or(glm::dvec2(0));
        if (!own) water.size.reset(), water.center.reset();
    }
    hint("where beams start from; else what the receivers can be lit from");
    if (water.size) vector("size", *water.size, {.speed = speed, .min = 1e-3}, "m along x and z");
    if (water.center) vector("center", *water.center, {.speed = speed}, "x and z, m");
}

/// Named waters; what a field changes is none of them.
void bodyCombo(Water& water) {
    const auto body = waterBodyOf(water);
    const std::string shown(body ? waterBodies[*body] : "its own");
    if (ImGui::BeginCombo("type", shown.c_str())) {
        for (std::size_t i = 0; i < std::size(waterBodies); ++i)
            if (ImGui::Selectable(std::string(waterBodies[i]).c_str(), body == i)) setWaterBody(i, water);
        ImGui::EndCombo();
    }
    hint("absorption, scattering and anisotropy from published tables");
}

/// How many of the waves a shader has to bind a texture for.
long textureCount(const std::vector<Wave>& waves) {
    return std::count_if(waves.begin(), waves.end(), [](const Wave& wave) { return isTexture(wave.type); });
}

void changeType(Wave& wave, WaveType type) {
    const double amplitude = wave.amplitude;
    if (isTexture(wave.type) || isTexture(type)) wave = {};
    wave.amplitude = amplitude;
    wave.type = type;
    if (type == WaveType::Phillips) raiseSea(wave, {});
}

/// A height map stays one: its pictures are in the scene's file.
void typeCombo(Wave& wave, bool roomForTextures) {
    if (wave.type == WaveType::HeightMap) {
        ImGui::TextDisabled("a height map, from the scene's file");
        return;
    }
    if (!ImGui::BeginCombo("type", waveTypeNames[std::size_t(wave.type)].data())) return;
    for (const WaveType type : {WaveType::Cosine, WaveType::Circular, WaveType::Noise, WaveType::Phillips})
        if (!isTexture(type) || roomForTextures || type == wave.type)
            if (ImGui::Selectable(waveTypeNames[std::size_t(type)].data(), type == wave.type) &&
                type != wave.type)
                changeType(wave, type);
    ImGui::EndCombo();
}

/// The angle of a direction, and back; its length stays.
bool headingField(glm::dvec2& direction, const char* tip) {
    double heading = glm::degrees(std::atan2(direction.y, direction.x));
    if (!number("heading", heading, {.speed = 0.3, .min = -360, .max = 360, .format = "%.1f°"}, tip))
        return false;
    const double angle = glm::radians(heading), length = glm::length(direction);
    direction = length * glm::dvec2(std::cos(angle), std::sin(angle));
    return true;
}

bool seedField(std::uint32_t& value) {
    int seed = int(std::min(value, 0x7FFFFFFFu));
    if (!wholeNumber("seed", seed, 0, 0x7FFFFFFF)) return false;
    value = std::uint32_t(seed);
    return true;
}

bool modesField(int& modes) {
    int exponent = int(std::lround(std::log2(modes)));
    const std::string shown = std::to_string(modes);
    if (!ImGui::SliderInt("modes", &exponent, 2, 9, shown.c_str(), ImGuiSliderFlags_NoInput)) return false;
    modes = 1 << exponent;
    return true;
}

/// What raises a sea. A wind that raises nothing changes nothing.
void windFields(Wave& wave) {
    Wind wind = windOf(wave);
    double speed = glm::length(wind.velocity);
    const glm::dvec2 direction = wind.velocity / speed;
    bool changed = number("wind", speed, {.speed = 0.02, .min = 0.1, .max = 100}, "m/s");
    wind.velocity = speed * direction;
    changed |= headingField(wind.velocity, "where the wind goes, from x towards z");
    changed |= vector("tile", wind.tile, {.speed = 0.02, .min = 0.01, .max = 1e6},
                      "m along x and z; the waves repeat after it");
    changed |= modesField(wind.modes);
    hint("waves along a side of the tile");
    changed |= number("shortest", wind.shortest, {.speed = 0.002, .min = 0, .max = 1e6},
                      "m; shorter waves die away; 0: as tile and modes have it");
    changed |= seedField(wind.seed);
    if (changed) raiseSea(wave, wind);
}

void waveFields(Wave& wave, double speed, bool roomForTextures) {
    typeCombo(wave, roomForTextures);
    const double fine = std::max(0.005 * std::abs(wave.amplitude), 1e-6);
    number("amplitude", wave.amplitude, {.speed = fine},
           wave.type == WaveType::Phillips ? "m, root mean square of the height"
                                           : "m, half of crest to trough");
    if (wave.type == WaveType::Phillips) windFields(wave);
    if (isTexture(wave.type)) return;
    number("wavelength", wave.wavelength, {.speed = 0.005 * wave.wavelength, .min = 1e-4}, "m");
    number("speed", wave.speed, {.speed = 0.005}, "m/s");
    if (wave.type == WaveType::Cosine) headingField(wave.direction, "from x towards z");
    if (wave.type == WaveType::Circular) vector("center", wave.center, {.speed = speed}, "x and z, m");
    if (wave.type == WaveType::Noise) {
        wholeNumber("octaves", wave.octaves, 1, 12);
        seedField(wave.seed);
    } else {
        number("phase", wave.phase, {.speed = 0.5, .format = "%.1f°"});
    }
}

void addWave(State& state) {
    if (ImGui::Button("Add")) {
        Wave wave;
        if (!state.scene.water.waves.empty()) wave = state.scene.water.waves.back();
        if (isTexture(wave.type)) wave = {};
        state.scene.water.waves.push_back(wave);
    }
    hint("another, like the last one");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-FLT_MIN);
    if (!ImGui::BeginCombo("##preset", "all of them from a preset")) return;
    for (std::size_t i = 0; i < std::size(waterPresets); ++i)
        if (ImGui::Selectable(std::string(waterPresets[i]).c_str()))
            state.scene.water.waves = presetWaves(i, state.scene.water.center.value_or(glm::dvec2(0)));
    ImGui::EndCombo();
}

} // namespace

void waterSection(State& state, double speed) {
    if (!section("Water")) return;
    ImGui::PushID("water");
    Water& water = state.scene.water;
    number("level", water.level, {.speed = speed}, "y of the mean surface, m");
    number("refraction", water.ior, {.speed = 0.002, .min = 1, .max = 4}, "index of refraction");
    bodyCombo(water);
    vector("absorption", water.absorption, perMetre, "1/m, RGB");
    vector("scattering", water.scattering, perMetre, "1/m, RGB");
    number("anisotropy", water.anisotropy, {.speed = 0.005, .min = -0.99, .max = 0.99},
           "mean cosine of the angle that scattering turns light by");
    wholeNumbers("grid", water.grid, 8, 2048, "quads along x and z");
    patchFields(water, speed);
    ImGui::PopID();
}

void wavesSection(State& state, double speed) {
    if (!section("Waves")) return;
    std::vector<Wave>& waves = state.scene.water.waves;
    const bool roomForTextures = textureCount(waves) < maxHeightMaps;
    std::optional<std::size_t> removed;
    for (std::size_t i = 0; i < waves.size(); ++i) {
        ImGui::PushID(int(i));
        const std::string label = fmt::format("{}: {}, {:.3g} m###wave", i,
                                              waveTypeNames[std::size_t(waves[i].type)], waves[i].amplitude);
        if (ImGui::TreeNode(label.c_str())) {
            waveFields(waves[i], speed, roomForTextures);
            if (ImGui::SmallButton("Remove")) removed = i;
            ImGui::TreePop();
        }
        ImGui::PopID();
    }
    if (removed) waves.erase(waves.begin() + std::ptrdiff_t(*removed));
    if (waves.empty()) ImGui::TextDisabled("none: the water is flat");
    addWave(state);
}

} // namespace limpid::viewer
