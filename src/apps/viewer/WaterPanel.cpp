#include "apps/viewer/WaterPanel.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "apps/viewer/KeyFields.h"
#include "scene/Sea.h"
#include "scene/WaterBodies.h"
#include "scene/WaterPresets.h"

namespace limpid::viewer {

using namespace widgets;

namespace {

void patchFields(Water& water, double speed) {
    bool own = water.size.has_value();
    if (ImGui::Checkbox("a patch of its own", &own)) {
        if (own) water.size = glm::dvec2(2), water.center = water.center.value_or(glm::dvec2(0));
        if (!own) water.size.reset(), water.center.reset();
    }
    hint("where beams start from; else what the receivers can be lit from");
    keyField(keyOf(waterKeys, &Water::size), water.size, speed);
    keyField(keyOf(waterKeys, &Water::center), water.center, speed);
}

/// Named waters; what a field changes is none of them.
void bodyCombo(const KeyRow& key, Water& water) {
    const auto body = waterBodyOf(water);
    const std::string shown(body ? waterBodies[*body] : "its own");
    const bool open = ImGui::BeginCombo(labelOf(key).c_str(), shown.c_str());
    keyHint(key);
    if (!open) return;
    for (std::size_t i = 0; i < std::size(waterBodies); ++i)
        if (ImGui::Selectable(std::string(waterBodies[i]).c_str(), body == i)) setWaterBody(i, water);
    ImGui::EndCombo();
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
void headingField(glm::dvec2& direction) {
    double heading = glm::degrees(std::atan2(direction.y, direction.x));
    if (!number("heading", heading, {.speed = 0.3, .min = -360, .max = 360, .format = "%.1f°"},
                "from x towards z"))
        return;
    const double angle = glm::radians(heading), length = glm::length(direction);
    direction = length * glm::dvec2(std::cos(angle), std::sin(angle));
}

/// A wind's speed and where it goes.
void windField(const KeyRow& key, glm::dvec2& velocity) {
    double speed = glm::length(velocity);
    const glm::dvec2 direction = velocity / speed;
    if (keyField(key, std::span(&speed, 1), {.speed = 0.02, .min = 0.1, .max = 100}))
        velocity = speed * direction;
    headingField(velocity);
}

/// Powers of two.
void modesField(const KeyRow& key, int& modes) {
    int exponent = int(std::lround(std::log2(modes)));
    const std::string shown = std::to_string(modes);
    if (ImGui::SliderInt(labelOf(key).c_str(), &exponent, int(std::log2(key.range().min)),
                         int(std::log2(key.range().max)), shown.c_str(), ImGuiSliderFlags_NoInput))
        modes = 1 << exponent;
    keyHint(key);
}

/// Draws what is not a number as the table has it; false for all else.
bool ownField(const Key<Wave>& key, Wave& wave, bool roomForTextures) {
    if (key.is(&Wave::type)) {
        typeCombo(wave, roomForTextures);
    } else if (key.is(&Wave::amplitude)) {
        const double fine = std::max(0.005 * std::abs(wave.amplitude), 1e-6);
        keyField(key, std::span(&wave.amplitude, 1), {.speed = fine});
    } else if (wave.type == WaveType::Phillips && key.is(&Wave::direction)) {
        windField(key, wave.direction);
    } else if (wave.type == WaveType::Phillips && key.is(&Wave::wavelength)) {
        Field field = fieldOf(key, wave.wavelength);
        field.min = 0; // as tile and modes have it
        keyField(key, std::span(&wave.wavelength, 1), field);
    } else if (key.is(&Wave::direction)) {
        headingField(wave.direction);
    } else if (key.is(&Wave::modes)) {
        modesField(key, wave.modes);
    } else {
        return wave.type == WaveType::HeightMap; // stays as its file has it
    }
    return true;
}

void waveFields(Wave& wave, double speed, bool roomForTextures) {
    const Wave before = wave;
    keyFields(waveKeys, wave, speed,
              [&](const Key<Wave>& key) { return ownField(key, wave, roomForTextures); });
    Wave higher = before;
    higher.amplitude = wave.amplitude;
    if (wave.type != WaveType::Phillips || before.type != wave.type || wave == higher) return;
    if (!raiseSea(wave, windOf(wave))) wave = higher; // a wind that raises nothing changes nothing
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
    keyFields(waterKeys, water, speed, [&](const Key<Water>& key) {
        if (key.name == "type") bodyCombo(key, water);
        if (key.is(&Water::center)) patchFields(water, speed);
        return key.is(&Water::center) || key.is(&Water::size);
    });
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
