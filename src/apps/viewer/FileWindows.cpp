#include "apps/viewer/FileWindows.h"
#include "apps/viewer/Saving.h"

#include <filesystem>

#include <imgui.h>
#include <imgui_stdlib.h>
#include <utility>

namespace limpid::viewer {

namespace {

constexpr ImGuiWindowFlags popup = ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove;

void centerNext() {
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
}

/// A field for a name, which has the keyboard. Returns whether Enter or the button said go.
bool nameField(const char* button, std::string& name) {
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(30 * ImGui::GetFontSize());
    const bool entered = ImGui::InputText("##name", &name, ImGuiInputTextFlags_EnterReturnsTrue);
    const bool pressed = ImGui::Button(button);
    ImGui::SameLine();
    if (ImGui::Button("Cancel") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape)))
        ImGui::CloseCurrentPopup();
    return (entered || pressed) && !name.empty();
}

void openWindow(State& state) {
    if (std::exchange(state.askOpen, false)) ImGui::OpenPopup("Open a scene or a model");
    centerNext();
    if (!ImGui::BeginPopupModal("Open a scene or a model", nullptr, popup)) return;
    ImGui::TextDisabled(".toml, .glb or .gltf; dropping it onto the window does the same");
    if (nameField("Open", state.openName)) {
        state.open = state.openName;
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

void saveWindow(State& state) {
    if (std::exchange(state.askSave, false)) {
        state.saveName = proposedScene(state.file);
        ImGui::OpenPopup("Save the scene");
    }
    centerNext();
    if (!ImGui::BeginPopupModal("Save the scene", nullptr, popup)) return;
    const bool exists = std::filesystem::exists(state.saveName);
    ImGui::TextDisabled(exists ? "there is a file of this name" : "a scene that limpid render reads");
    if (nameField(exists ? "Replace it" : "Save", state.saveName)) {
        state.saveScene = state.saveName;
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

} // namespace

void fileWindows(State& state) {
    openWindow(state);
    saveWindow(state);
}

} // namespace limpid::viewer
