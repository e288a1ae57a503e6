#include "apps/viewer/Widgets.h"

namespace limpid::viewer::widgets {

void hint(const char* text) {
    if (text && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) ImGui::SetTooltip("%s", text);
}

bool number(const char* label, double& value, const Field& field, const char* tip) {
    return numbers(label, &value, 1, field, tip);
}

bool numbers(const char* label, double* values, int count, const Field& field, const char* tip) {
    const bool changed = ImGui::DragScalarN(label, ImGuiDataType_Double, values, count, float(field.speed),
                                            &field.min, &field.max, field.format,
                                            ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoRoundToFormat);
    hint(tip);
    return changed;
}

bool wholeNumber(const char* label, int& value, int min, int max, const char* tip) {
    const bool changed = ImGui::DragInt(label, &value, 0.5f, min, max, "%d", ImGuiSliderFlags_AlwaysClamp);
    hint(tip);
    return changed;
}

bool wholeNumbers(const char* label, glm::ivec2& values, int min, int max, const char* tip) {
    const bool changed =
        ImGui::DragInt2(label, &values.x, 0.5f, min, max, "%d", ImGuiSliderFlags_AlwaysClamp);
    hint(tip);
    return changed;
}

bool section(const char* label, bool open) {
    return ImGui::CollapsingHeader(label, open ? ImGuiTreeNodeFlags_DefaultOpen : 0);
}

void row(const std::string& left, const std::string& right) {
    ImGui::TableNextRow();
    ImGui::TableSetColumnIndex(0);
    ImGui::TextUnformatted(left.c_str());
    ImGui::TableSetColumnIndex(1);
    const float width = ImGui::CalcTextSize(right.c_str()).x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(ImGui::GetContentRegionAvail().x - width, 0.0f));
    ImGui::TextUnformatted(right.c_str());
}

} // namespace limpid::viewer::widgets
