#include "apps/viewer/ScenePanel.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "apps/viewer/KeyFields.h"
#include "apps/viewer/MethodPanel.h"
#include "apps/viewer/WaterPanel.h"

namespace limpid::viewer {

using namespace widgets;

namespace {

constexpr Field degrees{.speed = 0.3, .min = -360, .max = 360, .format = "%.2f°"};

/// Metres a pixel of a drag: one over the whole panel moves things by about the scene's size.
double lengthSpeed(const State& state) {
    return 0.002 * state.extent;
}

void timeSection(State& state) {
    if (!section("Time", true)) return;
    if (ImGui::Button(state.playing ? "Pause" : "Play", ImVec2(4.5f * ImGui::GetFontSize(), 0)))
        state.playing = !state.playing;
    hint("Space");
    ImGui::SameLine();
    ImGui::PushButtonRepeat(true);
    if (ImGui::ArrowButton("back", ImGuiDir_Left)) state.step = -1;
    hint("a frame back (,)");
    ImGui::SameLine();
    if (ImGui::ArrowButton("on", ImGuiDir_Right)) state.step = 1;
    hint("a frame on (.)");
    ImGui::PopButtonRepeat();
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-FLT_MIN);
    number("##time", state.time, {.speed = 0.01, .min = -1e9, .max = 1e9, .format = "%.3f s"}, "time");
}

void cameraSection(State& state) {
    if (!section("Camera")) return;
    Camera& camera = state.scene.camera;
    const Camera before = camera;
    keyFields(cameraKeys, camera, lengthSpeed(state), [](const auto& key) {
        return key.is(&Camera::up) || key.is(&Camera::exposure); // stays, and stands below
    });
    if (*camera.position == *camera.target) camera = before;
    if (ImGui::Button("Frame")) state.frameSelection = true;
    hint("the picked receiver, or the scene (F)");
    ImGui::SameLine();
    if (ImGui::Button("Reset")) state.resetCamera = true;
    hint("to the scene's own (Home)");
}

/// A direction as a person thinks of a sun: how high it stands, and where.
void sunFields(Light& light) {
    const glm::dvec3 way = glm::normalize(light.direction);
    double height = glm::degrees(std::asin(std::clamp(-way.y, -1.0, 1.0)));
    double around = glm::degrees(std::atan2(way.z, way.x));
    const Field elevation{.speed = 0.2, .min = 1, .max = 90, .format = "%.2f°"};
    bool changed = number("height", height, elevation, "over the horizon");
    changed |= number("heading", around, degrees, "where its light goes, from x towards z");
    if (!changed) return;
    const double across = std::cos(glm::radians(height));
    light.direction = {across * std::cos(glm::radians(around)), -std::sin(glm::radians(height)),
                       across * std::sin(glm::radians(around))};
}

void lightFields(State& state, Light& light) {
    keyFields(lightKeys, light, lengthSpeed(state), [&](const auto& key) {
        if (!key.is(&Light::direction) || light.isSpot()) return false;
        sunFields(light);
        return true;
    });
    light.innerCone = std::min(light.innerCone, 0.99 * light.outerCone);
}

void lightSection(State& state) {
    if (!section("Lights")) return;
    for (std::size_t i = 0; i < state.scene.lights.size(); ++i) {
        Light& light = state.scene.lights[i];
        const ImGuiTreeNodeFlags open = state.scene.lights.size() == 1 ? ImGuiTreeNodeFlags_DefaultOpen : 0;
        if (!ImGui::TreeNodeEx(light.name.c_str(), open)) continue;
        lightFields(state, light);
        ImGui::TreePop();
    }
    if (state.scene.lights.empty()) ImGui::TextDisabled("none");
}

void gizmoChoice(State& state) {
    int mode = int(state.gizmo);
    const char* const names[] = {"move", "turn", "scale"};
    for (int i = 0; i < 3; ++i) {
        if (i > 0) ImGui::SameLine();
        ImGui::RadioButton(names[i], &mode, i);
        hint("what the handles in the picture do (T)");
    }
    state.gizmo = static_cast<Gizmo::Mode>(mode);
}

void receiverFields(State& state, Receiver& receiver) {
    gizmoChoice(state);
    const glm::dvec3 scale = receiver.scale;
    keyFields(receiverKeys, receiver, lengthSpeed(state), [&](const auto& key) {
        if (!key.is(&Receiver::rotation)) return false;
        // Angles about x, y and z. The turn is kept as a quaternion and shown as angles near by.
        glm::dvec3 angles = glm::degrees(glm::eulerAngles(receiver.rotation)) + 0.0; // no -0
        if (vector("rotation", angles, degrees, "degrees about x, y and z"))
            receiver.rotation = glm::normalize(glm::dquat(glm::radians(angles)));
        return true;
    });
    if (receiver.scale.x == 0 || receiver.scale.y == 0 || receiver.scale.z == 0) receiver.scale = scale;
    ImGui::TextDisabled("%zu triangles", receiver.mesh->triangleCount());
}

void receiverSection(State& state) {
    if (!section("Receivers", true)) return;
    for (std::size_t i = 0; i < state.scene.receivers.size(); ++i) {
        Receiver& receiver = state.scene.receivers[i];
        const bool selected = state.selected == int(i);
        ImGui::PushID(int(i));
        if (ImGui::Selectable(receiver.name.c_str(), selected))
            state.selected = selected ? std::nullopt : std::optional<int>(int(i));
        if (state.selected == int(i)) receiverFields(state, receiver);
        ImGui::PopID();
    }
    if (!state.selected) ImGui::TextDisabled("click one, here or in the picture");
}

void radianceField(const char* label, const KeyRow& key, glm::dvec3& radiance) {
    vector(label, radiance, fieldOf(key, glm::length(radiance)));
    keyHint(key);
}

void lookSection(State& state) {
    if (!section("Light around and exposure")) return;
    keyField(keyOf(cameraKeys, &Camera::exposure), state.scene.camera.exposure, 0);
    radianceField("sky", keyOf(skyKeys, &Scene::skyRadiance), state.scene.skyRadiance);
    radianceField("ambient", keyOf(ambientKeys, &Scene::ambientRadiance), state.scene.ambientRadiance);
}

} // namespace

void scenePanel(State& state) {
    ImGui::PushItemWidth(-0.37f * ImGui::GetContentRegionAvail().x);
    timeSection(state);
    receiverSection(state);
    methodSection(state);
    lightSection(state);
    waterSection(state, lengthSpeed(state));
    wavesSection(state, lengthSpeed(state));
    godraysSection(state);
    cameraSection(state);
    lookSection(state);
    ImGui::PopItemWidth();
}

} // namespace limpid::viewer
