#include "apps/viewer/GizmoOverlay.h"

#include <algorithm>

#include "apps/viewer/Overlay.h"

namespace limpid::viewer {

namespace {

constexpr ImU32 colors[] = {IM_COL32(235, 85, 85, 255), IM_COL32(120, 215, 90, 255),
                            IM_COL32(95, 150, 255, 255)};
constexpr ImU32 takenColor = IM_COL32(255, 225, 90, 255);

/// In letters' heights, so that they grow with the interface.
constexpr double handleLength = 5, handleReach = 0.5;
constexpr double mostOfPicture = 0.25; ///< of its shorter side, that a handle is long at most

bool shows(const State& state) {
    return state.panels && state.hasScene() && state.selected.has_value();
}

Gizmo gizmoOf(const State& state, const Projection& projection, const Area& picture) {
    const double most = mostOfPicture * std::min(picture.size.x, picture.size.y);
    const auto index = std::size_t(*state.selected);
    return Gizmo(state.scene.receivers[index], state.middles[index], state.gizmo, projection,
                 std::min(handleLength * ImGui::GetFontSize(), most));
}

glm::dvec2 mouseIn(const Area& picture) {
    const ImVec2 at = ImGui::GetIO().MousePos;
    return glm::dvec2(at.x, at.y) - glm::dvec2(picture.corner);
}

/// The end of a handle, by which it is told what it does.
void drawTip(Gizmo::Mode mode, const ImVec2& before, const ImVec2& tip, ImU32 color) {
    ImDrawList* list = ImGui::GetBackgroundDrawList();
    const float side = 0.35f * ImGui::GetFontSize();
    if (mode == Gizmo::Mode::Scale) {
        list->AddRectFilled(ImVec2(tip.x - side, tip.y - side), ImVec2(tip.x + side, tip.y + side), color);
        return;
    }
    const glm::vec2 way(tip.x - before.x, tip.y - before.y);
    if (way == glm::vec2(0)) return;
    const glm::vec2 ahead = side * glm::normalize(way);
    list->AddTriangleFilled(ImVec2(tip.x + 2 * ahead.x, tip.y + 2 * ahead.y),
                            ImVec2(tip.x - ahead.y, tip.y + ahead.x),
                            ImVec2(tip.x + ahead.y, tip.y - ahead.x), color);
}

void drawHandle(const Gizmo& gizmo, int axis, const Overlay& overlay, ImU32 color) {
    const bool ring = gizmo.mode == Gizmo::Mode::Turn;
    const double begin = ring ? gizmo.ends().x : 0;
    const auto point = [&](double t) { return gizmo.at(axis, glm::mix(begin, gizmo.ends().y, t)); };
    const auto end = overlay.curve(point, ring ? 64 : 12, color, 0.16f * ImGui::GetFontSize());
    if (end && !ring) drawTip(gizmo.mode, end->first, end->second, color);
}

void dragOn(State& state, const Projection& projection, const Area& picture) {
    const ImGuiIO& io = ImGui::GetIO();
    if (!io.MouseDown[0]) {
        state.drag.reset();
        return;
    }
    if (io.MouseDelta.x == 0 && io.MouseDelta.y == 0) return;
    state.scene.receivers[std::size_t(*state.selected)] =
        state.drag->to(mouseIn(picture), projection, io.KeyShift);
}

} // namespace

bool takeGizmo(State& state, const Area& picture) {
    if (!shows(state)) {
        state.drag.reset();
        state.handle.reset();
        return false;
    }
    const Projection projection(state.scene.camera, state.scene.water, glm::dvec2(picture.size));
    if (state.drag) {
        dragOn(state, projection, picture);
        return true;
    }
    const ImGuiIO& io = ImGui::GetIO();
    if (io.MouseDown[1] || io.MouseDown[2] || (io.MouseDown[0] && !ImGui::IsMouseClicked(0))) return false;
    state.handle.reset();
    if (io.WantCaptureMouse) return false;
    const Gizmo gizmo = gizmoOf(state, projection, picture);
    state.handle = gizmo.under(mouseIn(picture), handleReach * ImGui::GetFontSize(), projection);
    if (!state.handle || !ImGui::IsMouseClicked(0)) return false;
    state.drag.emplace(state.scene.receivers[std::size_t(*state.selected)], gizmo, *state.handle,
                       mouseIn(picture), projection);
    return true;
}

void drawGizmo(const State& state, const Area& picture) {
    if (!shows(state)) return;
    const Overlay overlay(state.scene, picture);
    const Gizmo gizmo = gizmoOf(state, overlay.projection(), picture);
    for (int axis = 0; axis < Gizmo::axisCount; ++axis) {
        const bool taken = state.handle == axis;
        if (!gizmo.hidden[axis] || taken) drawHandle(gizmo, axis, overlay, taken ? takenColor : colors[axis]);
    }
}

} // namespace limpid::viewer
