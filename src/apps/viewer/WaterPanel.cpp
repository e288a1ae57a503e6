#include "apps/viewer/WaterPanel.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "apps/viewer/Widgets.h"
#include "io/WaterPresets.h"

namespace limpid::viewer {

using namespace widgets;

namespace {

constexpr Field perMetre{.speed = 0.002, .min = 0, .max = 1e12};

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

void typeCombo(Wave& wave) {
    if (isTexture(wave.type)) {
        const bool map = wave.type == WaveType::HeightMap;
        ImGui::TextDisabled("%s, from the scene's file", map ? "a height map" : "a sea by its spectrum");
        return;
    }
    int type = int(wave.type);
    if (ImGui::Combo("type", &type, "cosine\0circular\0noise\0")) wave.type = static_cast<WaveType>(type);
}

void waveFields(Wave& wave, double speed) {
    typeCombo(wave);
    const double fine = std::max(0.005 * std::abs(wave.amplitude), 1e-6);
    number("amplitude", wave.amplitude, {.speed = fine}, "m, half of crest to trough");
    if (isTexture(wave.type)) return;
    number("wavelength", wave.wavelength, {.speed = 0.005 * wave.wavelength, .min = 1e-4}, "m");
    number("speed", wave.speed, {.speed = 0.005}, "m/s");
    if (wave.type == WaveType::Cosine) {
        double heading = glm::degrees(std::atan2(wave.direction.y, wave.direction.x));
        if (number("heading", heading, {.speed = 0.3, .min = -360, .max = 360, .format = "%.1f°"},
                   "from x towards z"))
            wave.direction = {std::cos(glm::radians(heading)), std::sin(glm::radians(heading))};
    }
    if (wave.type == WaveType::Circular) vector("center", wave.center, {.speed = speed}, "x and z, m");
    if (wave.type == WaveType::Noise) {
        wholeNumber("octaves", wave.octaves, 1, 12);
        int seed = int(std::min(wave.seed, 0x7FFFFFFFu));
        if (wholeNumber("seed", seed, 0, 0x7FFFFFFF)) wave.seed = std::uint32_t(seed);
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
    for (std::size_t i = 0; i < std::size(io::waterPresets); ++i)
        if (ImGui::Selectable(std::string(io::waterPresets[i]).c_str()))
            state.scene.water.waves = io::presetWaves(i, state.scene.water.center.value_or(glm::dvec2(0)));
    ImGui::EndCombo();
}

} // namespace

void waterSection(State& state, double speed) {
    if (!section("Water")) return;
    ImGui::PushID("water");
    Water& water = state.scene.water;
    number("level", water.level, {.speed = speed}, "y of the mean surface, m");
    number("refraction", water.ior, {.speed = 0.002, .min = 1, .max = 4}, "index of refraction");
    vector("absorption", water.absorption, perMetre, "1/m, RGB");
    vector("scattering", water.scattering, perMetre, "1/m, RGB");
    ImGui::DragInt2("grid", &water.grid.x, 1, 8, 2048, "%d", ImGuiSliderFlags_AlwaysClamp);
    hint("quads along x and z");
    patchFields(water, speed);
    ImGui::PopID();
}

void wavesSection(State& state, double speed) {
    if (!section("Waves")) return;
    std::vector<Wave>& waves = state.scene.water.waves;
    std::optional<std::size_t> removed;
    for (std::size_t i = 0; i < waves.size(); ++i) {
        ImGui::PushID(int(i));
        const std::string label = fmt::format("{}: {}, {:.3g} m###wave", i,
                                              waveTypeNames[std::size_t(waves[i].type)], waves[i].amplitude);
        if (ImGui::TreeNode(label.c_str())) {
            waveFields(waves[i], speed);
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
