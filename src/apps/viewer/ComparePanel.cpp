#include "apps/viewer/ComparePanel.h"

#include <fmt/format.h>
#include <imgui.h>

#include "apps/viewer/MethodPanel.h"
#include "apps/viewer/Widgets.h"

namespace limpid::viewer {

namespace {

void label(const std::string& text, float x, float y, float alignment) {
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const ImVec2 at(x - alignment * size.x, y);
    const float margin = 0.3f * ImGui::GetFontSize();
    ImDrawList* list = ImGui::GetBackgroundDrawList();
    list->AddRectFilled(ImVec2(at.x - margin, at.y - margin),
                        ImVec2(at.x + size.x + margin, at.y + size.y + margin), IM_COL32(0, 0, 0, 140), 3);
    list->AddText(at, IM_COL32(255, 255, 255, 255), text.c_str());
}

} // namespace

void comparePanel(State& state) {
    ImGui::TextWrapped("The same scene by a second method.");
    ImGui::PushItemWidth(-0.3f * ImGui::GetContentRegionAvail().x);
    methodField(state.scene.caustics.method);
    const std::string other = state.other ? std::string(methodName(*state.other)) : "none";
    if (ImGui::BeginCombo("second", other.c_str())) {
        if (ImGui::Selectable("none", !state.other)) state.other.reset();
        for (const Method method : allMethods())
            if (ImGui::Selectable(std::string(methodName(method)).c_str(), state.other == method))
                state.other = method;
        ImGui::EndCombo();
    }
    if (state.other) {
        int difference = state.shown.mode == Shown::Mode::Difference;
        ImGui::RadioButton("side by side", &difference, 0);
        ImGui::RadioButton("difference", &difference, 1);
        state.shown.mode = difference ? Shown::Mode::Difference : Shown::Mode::Split;
        if (difference) {
            widgets::number("times", state.shown.difference,
                            {.speed = 0.1, .min = 1, .max = 255, .format = "%.1f"},
                            "differences of displayed colours are multiplied with this");
        } else {
            float split = float(state.shown.split);
            if (ImGui::SliderFloat("split", &split, 0, 1, "%.2f")) state.shown.split = split;
        }
        ImGui::TextDisabled("two engines at work:\ntwice the time and memory");
    }
    ImGui::PopItemWidth();
}

void compareOverlay(const State& state, const Area& picture) {
    if (!state.other || !state.hasScene()) return;
    const float x = float(picture.corner.x), y = float(picture.corner.y),
                margin = 0.7f * ImGui::GetFontSize();
    const std::string first(methodName(state.scene.caustics.method)), second(methodName(*state.other));
    if (state.shown.mode == Shown::Mode::Difference) {
        label(fmt::format("{:.1f} · |{} − {}|", state.shown.difference, first, second), x + margin,
              y + margin, 0);
        return;
    }
    const float line = x + float(state.shown.split) * float(picture.size.x);
    ImGui::GetBackgroundDrawList()->AddLine(ImVec2(line, y), ImVec2(line, y + float(picture.size.y)),
                                            IM_COL32(255, 255, 255, 200));
    label(first, line - margin, y + margin, 1);
    label(second, line + margin, y + margin, 0);
}

} // namespace limpid::viewer
