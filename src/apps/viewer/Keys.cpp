#include "apps/viewer/Keys.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <imgui.h>
// Its names of keys only.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "apps/viewer/CameraControl.h"
#include "apps/viewer/GizmoOverlay.h"
#include "apps/viewer/Pick.h"

namespace limpid::viewer {

namespace {

constexpr KeyHelp help[] = {
    {"left drag", "orbit"},
    {"right or middle drag", "pan (also Shift + left)"},
    {"wheel", "zoom"},
    {"W A S D, Q E", "fly; Shift: faster"},
    {"click", "pick a receiver"},
    {"T", "its handles: move, turn, scale (Shift: all axes alike)"},
    {"Ctrl Z", "undo; Ctrl Y: do it again"},
    {"F", "frame the picked receiver, or the scene"},
    {"Home", "the scene's own camera"},
    {"Space", "play, pause"},
    {", and .", "a frame back, on (1/30 s); 0: to the start"},
    {"1 2 3", "measure; understand; compare"},
    {"B", "boxes; G: planes; R: beams of the picked receiver"},
    {"- and +", "exposure, a third of a stop"},
    {"P", "save the picture; V: record a sequence"},
    {"Ctrl S", "save the scene; Ctrl O: open another"},
    {"Tab", "hide or show the interface; F11: full screen"},
    {"?", "these keys; Esc: close, pick nothing"},
    {"Ctrl Q", "leave"},
};

bool pressed(int key, bool repeat = false) {
    return ImGui::IsKeyPressed(key, repeat);
}

bool charTyped(unsigned wanted) {
    for (const ImWchar c : ImGui::GetIO().InputQueueCharacters)
        if (c == wanted) return true;
    return false;
}

bool drag(Camera& camera, const Area& picture) {
    const ImGuiIO& io = ImGui::GetIO();
    const glm::dvec2 moved(io.MouseDelta.x, io.MouseDelta.y);
    // The few pixels of a shaky click are no drag.
    const bool left = ImGui::IsMouseDragging(ImGuiMouseButton_Left);
    const bool other = ImGui::IsMouseDragging(ImGuiMouseButton_Right, 0) ||
                       ImGui::IsMouseDragging(ImGuiMouseButton_Middle, 0);
    if ((!left && !other) || moved == glm::dvec2(0)) return false;
    if (left && !io.KeyShift)
        orbit(camera, std::numbers::pi * moved / double(std::max(picture.size.y, 1)));
    else
        pan(camera, moved / double(std::max(picture.size.y, 1)));
    return true;
}

bool flyByKeys(Camera& camera, double seconds) {
    glm::dvec3 way(0);
    const auto both = [](int more, int less) {
        return double(ImGui::IsKeyDown(more)) - double(ImGui::IsKeyDown(less));
    };
    way = {both(GLFW_KEY_D, GLFW_KEY_A), both(GLFW_KEY_E, GLFW_KEY_Q), both(GLFW_KEY_W, GLFW_KEY_S)};
    if (way == glm::dvec3(0)) return false;
    // Of the distance to the target in a second; a slow frame must not throw the camera far.
    const double speed = ImGui::GetIO().KeyShift ? 2.0 : 0.6;
    fly(camera, speed * std::min(seconds, 0.25) * way);
    return true;
}

bool moveCamera(State& state, const Area& picture, double seconds) {
    ImGuiIO& io = ImGui::GetIO();
    Camera& camera = state.scene.camera;
    bool moved = false;
    if (!io.WantCaptureMouse) {
        moved |= drag(camera, picture);
        if (io.MouseWheel != 0) {
            zoom(camera, std::pow(0.88, double(io.MouseWheel)));
            moved = true;
        }
    }
    if (!io.WantCaptureKeyboard && !io.KeyCtrl) moved |= flyByKeys(camera, seconds);
    return moved;
}

void pickByClick(State& state, const Area& picture) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantCaptureMouse || !ImGui::IsMouseReleased(ImGuiMouseButton_Left)) return;
    if (io.MouseDragMaxDistanceSqr[0] >= io.MouseDragThreshold * io.MouseDragThreshold) return;
    const glm::dvec2 at = glm::dvec2(io.MousePos.x, io.MousePos.y) - glm::dvec2(picture.corner);
    const Projection projection(state.scene.camera, state.scene.water, glm::dvec2(picture.size));
    const auto hit = pick(state.scene, projection.ray(at));
    state.selected = hit ? std::optional<int>(hit->receiver) : std::nullopt;
}

void toggleSide(State& state, State::Side side) {
    state.side = state.side == side ? State::Side::None : side;
    state.panels = true;
}

void takeSceneKeys(State& state) {
    if (pressed(GLFW_KEY_SPACE)) state.playing = !state.playing;
    if (pressed(GLFW_KEY_PERIOD, true)) state.step = 1;
    if (pressed(GLFW_KEY_COMMA, true)) state.step = -1;
    if (pressed(GLFW_KEY_0)) state.time = 0;
    if (pressed(GLFW_KEY_T)) state.gizmo = static_cast<Gizmo::Mode>((int(state.gizmo) + 1) % 3);
    if (pressed(GLFW_KEY_F)) state.frameSelection = true;
    if (pressed(GLFW_KEY_HOME)) state.resetCamera = true;
    if (pressed(GLFW_KEY_1)) toggleSide(state, State::Side::Measure);
    if (pressed(GLFW_KEY_2)) toggleSide(state, State::Side::Understand);
    if (pressed(GLFW_KEY_3)) toggleSide(state, State::Side::Compare);
    if (pressed(GLFW_KEY_B)) state.boxes = !state.boxes;
    if (pressed(GLFW_KEY_G)) state.planes = !state.planes;
    if (pressed(GLFW_KEY_R)) state.beams = !state.beams;
    if (charTyped('-')) state.scene.camera.exposure -= 1.0 / 3;
    if (charTyped('+')) state.scene.camera.exposure += 1.0 / 3;
    if (pressed(GLFW_KEY_P)) state.savePicture = true;
    if (pressed(GLFW_KEY_V)) state.record = true;
}

void takeWindowKeys(State& state) {
    if (charTyped('?')) state.keys = !state.keys;
    if (pressed(GLFW_KEY_TAB)) state.panels = !state.panels;
    if (pressed(GLFW_KEY_ESCAPE)) {
        if (state.keys)
            state.keys = false;
        else if (!state.message.empty())
            state.message.clear();
        else
            state.selected.reset();
    }
}

} // namespace

std::span<const KeyHelp> keyHelp() {
    return help;
}

bool takeInput(State& state, const Area& picture, double seconds) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool typing = io.WantTextInput;
    if (!typing && !io.KeyCtrl) takeWindowKeys(state);
    if (pressed(GLFW_KEY_F11)) state.fullscreen = !state.fullscreen;
    if (io.KeyCtrl && pressed(GLFW_KEY_Q)) state.leave = true;
    if (!typing && io.KeyCtrl && pressed(GLFW_KEY_O)) state.askOpen = true;
    if (!state.hasScene()) return false;
    if (!typing && io.KeyCtrl && pressed(GLFW_KEY_S)) state.askSave = true;
    if (!typing && io.KeyCtrl && pressed(GLFW_KEY_Z, true)) (io.KeyShift ? state.redo : state.undo) = true;
    if (!typing && io.KeyCtrl && pressed(GLFW_KEY_Y, true)) state.redo = true;
    if (!typing && !io.KeyCtrl) takeSceneKeys(state);
    if (takeGizmo(state, picture)) return true;
    pickByClick(state, picture);
    return moveCamera(state, picture, seconds);
}

} // namespace limpid::viewer
