#include "apps/viewer/Interface.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <imgui.h>

#include "apps/viewer/ComparePanel.h"
#include "apps/viewer/FileWindows.h"
#include "apps/viewer/MeasurePanel.h"
#include "apps/viewer/ScenePanel.h"

namespace limpid::viewer {

namespace {

constexpr ImGuiWindowFlags fixed = ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoBringToFrontOnFocus |
                                   ImGuiWindowFlags_NoTitleBar;

void place(float x, float y, float width, float height) {
    ImGui::SetNextWindowPos(ImVec2(x, y));
    ImGui::SetNextWindowSize(ImVec2(width, height));
}

void fileMenu(State& state) {
    if (!ImGui::BeginMenu("File")) return;
    if (ImGui::MenuItem("Open…", "Ctrl O")) state.askOpen = true;
    if (ImGui::MenuItem("Save scene…", "Ctrl S", false, state.hasScene())) state.askSave = true;
    if (ImGui::MenuItem("Save picture", "P", false, state.hasScene())) state.savePicture = true;
    if (ImGui::MenuItem("Record a sequence", "V", state.recording, state.hasScene())) state.record = true;
    if (ImGui::MenuItem("Leave", "Ctrl Q")) state.leave = true;
    ImGui::EndMenu();
}

void editMenu(State& state) {
    if (!ImGui::BeginMenu("Edit", state.hasScene())) return;
    if (ImGui::MenuItem("Undo", "Ctrl Z")) state.undo = true;
    if (ImGui::MenuItem("Do it again", "Ctrl Y")) state.redo = true;
    ImGui::EndMenu();
}

void sideItem(State& state, const char* label, const char* key, State::Side side) {
    if (ImGui::MenuItem(label, key, state.side == side))
        state.side = state.side == side ? State::Side::None : side;
}

void viewMenu(State& state) {
    if (!ImGui::BeginMenu("View")) return;
    sideItem(state, "Measure", "1", State::Side::Measure);
    sideItem(state, "Understand", "2", State::Side::Understand);
    sideItem(state, "Compare", "3", State::Side::Compare);
    ImGui::Separator();
    ImGui::MenuItem("Boxes", "B", &state.boxes);
    ImGui::MenuItem("Reference planes", "G", &state.planes);
    ImGui::MenuItem("Beams", "R", &state.beams);
    ImGui::Separator();
    if (ImGui::MenuItem("Frame", "F")) state.frameSelection = true;
    if (ImGui::MenuItem("The scene's camera", "Home")) state.resetCamera = true;
    ImGui::MenuItem("Interface", "Tab", &state.panels);
    ImGui::MenuItem("Full screen", "F11", &state.fullscreen);
    ImGui::EndMenu();
}

void menuBar(State& state) {
    if (!ImGui::BeginMainMenuBar()) return;
    fileMenu(state);
    editMenu(state);
    viewMenu(state);
    if (ImGui::BeginMenu("Help")) {
        ImGui::MenuItem("Keys", "?", &state.keys);
        ImGui::EndMenu();
    }
    const std::string name = state.hasScene() ? state.file.filename().string() : "no scene";
    const float width = ImGui::CalcTextSize(name.c_str()).x;
    ImGui::SameLine(std::max(ImGui::GetWindowWidth() - width - ImGui::GetFontSize(), 0.0f));
    ImGui::TextDisabled("%s", name.c_str());
    ImGui::EndMainMenuBar();
}

std::string progressText(const State& state, const Stage& stage) {
    if (!state.hasScene()) return "";
    if (state.recording) return "recording";
    if (stage.rests()) return "complete";
    return fmt::format("{:.0f} % resolution{}, refining", 100 * stage.resolution(),
                       stage.fullMaps() ? "" : ", coarse caustics");
}

/// Time, progress and, while pictures follow each other, how fast they do.
void statusTexts(const Shows& shows) {
    const float gap = ImGui::GetFontSize();
    ImGui::Text("t = %.3f s", shows.state.time);
    ImGui::SameLine(0, gap);
    ImGui::TextUnformatted(progressText(shows.state, shows.stage).c_str());
    ImGui::SameLine(0, gap);
    if (const int rate = shows.measured.perSecond(); rate > 1) {
        ImGui::Text("%d fps", rate);
        ImGui::SameLine(0, gap);
    }
}

void statusBar(const Shows& shows, const Layout& layout) {
    const State& state = shows.state;
    const float letter = ImGui::GetFontSize();
    place(0, float(layout.window.y) - layout.bottom, float(layout.window.x), layout.bottom);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.6f * letter, 0.25f * letter));
    if (ImGui::Begin("status", nullptr, fixed | ImGuiWindowFlags_NoScrollbar)) {
        if (state.hasScene()) statusTexts(shows);
        if (!state.notice.empty())
            ImGui::TextColored(ImVec4(0.6f, 0.9f, 0.6f, 1), "%s", state.notice.c_str());
        else if (float(layout.window.x) > 55 * letter)
            ImGui::TextDisabled("%s", shows.context.info().renderer.c_str());
        const char* keys = state.playing ? "Space: pause   ?: keys" : "Space: play   ?: keys";
        const float at = float(layout.window.x) - ImGui::CalcTextSize(keys).x - 0.6f * letter;
        if (float(layout.window.x) > 30 * letter) {
            ImGui::SameLine(at);
            ImGui::TextDisabled("%s", keys);
        }
    }
    ImGui::End();
    ImGui::PopStyleVar();
}

void sidePanel(const Shows& shows, const Layout& layout) {
    place(float(layout.window.x) - layout.right, layout.top, layout.right,
          float(layout.window.y) - layout.top - layout.bottom);
    if (ImGui::Begin("side", nullptr, fixed)) {
        const State::Side side = shows.state.side;
        if (side == State::Side::Measure) measurePanel(shows.measured, shows.stage, shows.context);
        if (side == State::Side::Understand) shows.understanding.panel(shows.state, shows.stage);
        if (side == State::Side::Compare) comparePanel(shows.state);
    }
    ImGui::End();
}

void keysWindow(State& state, const Layout& layout) {
    ImGui::SetNextWindowPos(ImVec2(0.5f * float(layout.window.x), 0.5f * float(layout.window.y)),
                            ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    if (ImGui::Begin("Keys", &state.keys,
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse |
                         ImGuiWindowFlags_NoMove)) {
        if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
            for (const KeyHelp& each : keyHelp()) {
                ImGui::TableNextRow();
                ImGui::TableSetColumnIndex(0);
                ImGui::TextColored(ImVec4(0.55f, 0.8f, 1, 1), "%s", each.keys);
                ImGui::TableSetColumnIndex(1);
                ImGui::TextUnformatted(each.does);
            }
            ImGui::EndTable();
        }
    }
    ImGui::End();
}

void messageWindow(State& state, const Layout& layout) {
    const Area& area = layout.picture;
    const float margin = ImGui::GetFontSize();
    ImGui::SetNextWindowPos(ImVec2(float(area.corner.x) + margin, float(area.corner.y) + margin));
    ImGui::SetNextWindowSize(ImVec2(std::max(float(area.size.x) - 2 * margin, 8 * margin), 0));
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImVec4(0.42f, 0.12f, 0.10f, 0.96f));
    if (ImGui::Begin("message", nullptr,
                     (fixed & ~ImGuiWindowFlags_NoBringToFrontOnFocus) |
                         ImGuiWindowFlags_NoFocusOnAppearing)) {
        ImGui::PushTextWrapPos(0);
        ImGui::TextUnformatted(state.message.c_str());
        ImGui::PopTextWrapPos();
        if (ImGui::Button("Dismiss")) state.message.clear();
    }
    ImGui::End();
    ImGui::PopStyleColor();
}

void welcome(const Layout& layout) {
    const char* text = "Drop a scene (.toml) or a model (.glb, .gltf) here, or press Ctrl O";
    const ImVec2 size = ImGui::CalcTextSize(text);
    const Area& area = layout.picture;
    const ImVec2 at(float(area.corner.x) + 0.5f * (float(area.size.x) - size.x),
                    float(area.corner.y) + 0.5f * (float(area.size.y) - size.y));
    ImGui::GetBackgroundDrawList()->AddText(at, IM_COL32(200, 200, 200, 255), text);
}

} // namespace

Layout layoutOf(const State& state, glm::ivec2 window) {
    Layout layout;
    layout.window = window;
    if (state.panels) {
        const float letter = ImGui::GetFontSize();
        layout.top = ImGui::GetFrameHeight();
        layout.bottom = 1.6f * letter;
        if (state.hasScene()) layout.left = std::min(19 * letter, 0.45f * float(window.x));
        if (state.hasScene() && state.side != State::Side::None)
            layout.right = std::min(21 * letter, 0.35f * float(window.x));
    }
    layout.picture.corner = glm::ivec2(std::lround(layout.left), std::lround(layout.top));
    layout.picture.size = glm::max(window - layout.picture.corner -
                                       glm::ivec2(std::lround(layout.right), std::lround(layout.bottom)),
                                   glm::ivec2(1));
    return layout;
}

void drawPicture(const Stage& stage, const Layout& layout) {
    const Display* display = stage.display();
    if (!display) return;
    const glm::vec2 from(layout.picture.corner), to(layout.picture.corner + layout.picture.size);
    // OpenGL's row 0 is at the bottom.
    ImGui::GetBackgroundDrawList()->AddImage(
        reinterpret_cast<ImTextureID>(std::uintptr_t(display->picture().id())), ImVec2(from.x, from.y),
        ImVec2(to.x, to.y), ImVec2(0, 1), ImVec2(1, 0));
}

void drawInterface(const Shows& shows, const Layout& layout) {
    State& state = shows.state;
    if (!state.hasScene()) welcome(layout);
    if (state.panels) {
        menuBar(state);
        statusBar(shows, layout);
        if (layout.left > 0) {
            place(0, layout.top, layout.left, float(layout.window.y) - layout.top - layout.bottom);
            if (ImGui::Begin("scene", nullptr, fixed)) scenePanel(state);
            ImGui::End();
        }
        if (layout.right > 0) sidePanel(shows, layout);
    }
    if (state.keys) keysWindow(state, layout);
    if (!state.message.empty()) messageWindow(state, layout);
    fileWindows(state);
}

} // namespace limpid::viewer
