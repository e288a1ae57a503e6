#include "apps/viewer/KeyFields.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace limpid::viewer::widgets {

std::string labelOf(const KeyRow& key) {
    std::string label(key.name);
    std::replace(label.begin(), label.end(), '_', ' ');
    return label;
}

void keyHint(const KeyRow& key) {
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
        hint(fmt::format("{}{}{}", key.says, key.unit.empty() ? "" : ", ", key.unit).c_str());
}

Field fieldOf(const KeyRow& key, double value, double length) {
    const Range& range = key.range();
    const double width = range.max - range.min, size = std::abs(value);
    // A bound that a number may only come near to.
    const double gap = 1e-4 * std::min(width, 1.0);
    Field field{.min = range.openMin ? range.min + gap : range.min,
                .max = range.openMax ? range.max - gap : range.max};
    if (width <= 1000)
        field.speed = 0.003 * size + 0.0005 * std::min(width, 40.0);
    else if (key.unit == "degrees")
        field.speed = 0.3;
    else if (key.unit == "m")
        field.speed = range.min < 0 ? length : 0.005 * size + 0.05 * length;
    else
        field.speed = range.min < 0 ? 0.005 * std::max(size, 1.0) : 0.005 * size + 0.002;
    if (key.unit == "degrees") field.format = "%.2f°";
    if (key.unit == "stops") field.format = "%.2f stops";
    return field;
}

bool keyField(const KeyRow& key, std::span<double> values, const Field& field) {
    const bool changed = numbers(labelOf(key).c_str(), values.data(), int(values.size()), field);
    keyHint(key);
    return changed;
}

bool keyField(const KeyRow& key, double& value, double length) {
    return keyField(key, std::span(&value, 1), fieldOf(key, value, length));
}

bool keyField(const KeyRow& key, int& value, double) {
    const bool changed = wholeNumber(labelOf(key).c_str(), value, int(key.range().min), int(key.range().max));
    keyHint(key);
    return changed;
}

bool keyField(const KeyRow& key, std::uint32_t& value, double) {
    const auto min = std::uint32_t(key.range().min), max = std::uint32_t(key.range().max);
    const bool changed = ImGui::DragScalar(labelOf(key).c_str(), ImGuiDataType_U32, &value, 0.5f, &min, &max,
                                           "%u", ImGuiSliderFlags_AlwaysClamp);
    keyHint(key);
    return changed;
}

bool keyField(const KeyRow& key, glm::ivec2& value, double) {
    const bool changed =
        wholeNumbers(labelOf(key).c_str(), value, int(key.range().min), int(key.range().max));
    keyHint(key);
    return changed;
}

bool keyChoice(const KeyRow& key, std::size_t& value) {
    const auto names = key.choice().names;
    bool changed = false;
    const bool open = ImGui::BeginCombo(labelOf(key).c_str(), std::string(names[value]).c_str());
    keyHint(key);
    if (!open) return false;
    for (std::size_t i = 0; i < names.size(); ++i)
        if (ImGui::Selectable(std::string(names[i]).c_str(), i == value) && i != value)
            value = i, changed = true;
    ImGui::EndCombo();
    return changed;
}

} // namespace limpid::viewer::widgets
