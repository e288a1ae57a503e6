#include "apps/viewer/MeasurePanel.h"

#include <algorithm>

#include <fmt/format.h>
#include <imgui.h>

#include "apps/viewer/Widgets.h"
#include "core/Statistics.h"
#include "scene/MethodFacts.h"

namespace limpid::viewer {

using namespace widgets;

namespace {

constexpr ImU32 colors[] = {
    IM_COL32(80, 160, 230, 255),  IM_COL32(240, 170, 70, 255),  IM_COL32(110, 200, 120, 255),
    IM_COL32(220, 100, 100, 255), IM_COL32(160, 130, 220, 255), IM_COL32(90, 200, 200, 255),
    IM_COL32(230, 130, 190, 255), IM_COL32(190, 190, 100, 255), IM_COL32(150, 150, 150, 255)};

using Passes = std::vector<std::pair<std::string, double>>;

double totalOf(const Passes& passes) {
    double total = 0;
    for (const auto& [pass, ms] : passes)
        total += ms;
    return total;
}

/// Every pass of the frames that are kept, in the order in which they came.
std::vector<std::string> passNames(const Measured& measured) {
    std::vector<std::string> names;
    for (const Measured::Frame& frame : measured.frames)
        for (const auto& [pass, ms] : frame.passes)
            if (std::find(names.begin(), names.end(), pass) == names.end()) names.push_back(pass);
    return names;
}

ImU32 colorOf(const std::vector<std::string>& names, const std::string& pass) {
    const auto at = std::size_t(std::find(names.begin(), names.end(), pass) - names.begin());
    return colors[at % std::size(colors)];
}

/// A bar for each picture, its passes stacked; the newest on the right.
void graph(const Measured& measured, const std::vector<std::string>& names) {
    double most = 1;
    for (const Measured::Frame& frame : measured.frames)
        most = std::max(most, totalOf(frame.passes));
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const ImVec2 size(ImGui::GetContentRegionAvail().x, 7 * ImGui::GetFontSize());
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddRectFilled(from, ImVec2(from.x + size.x, from.y + size.y), IM_COL32(20, 22, 26, 255));
    const float width = size.x / float(Measured::kept);
    float x = from.x + size.x - width * float(measured.frames.size());
    for (const Measured::Frame& frame : measured.frames) {
        float y = from.y + size.y;
        for (const auto& [pass, ms] : frame.passes) {
            const float tall = float(ms / most) * size.y;
            list->AddRectFilled(ImVec2(x, y - tall), ImVec2(x + std::max(width - 0.5f, 1.0f), y),
                                colorOf(names, pass));
            y -= tall;
        }
        x += width;
    }
    list->AddText(ImVec2(from.x + 4, from.y + 2), IM_COL32(200, 200, 200, 255),
                  fmt::format("{:.1f} ms", most).c_str());
    ImGui::Dummy(size);
    hint("GPU time of the last pictures by pass");
}

void passTable(const Measured& measured, const std::vector<std::string>& names) {
    if (!ImGui::BeginTable("passes", 2)) return;
    const Passes& last = measured.frames.back().passes;
    for (const std::string& name : names) {
        const auto found =
            std::find_if(last.begin(), last.end(), [&](const auto& p) { return p.first == name; });
        ImGui::PushStyleColor(ImGuiCol_Text, colorOf(names, name));
        row(name, found == last.end() ? "rests" : fmt::format("{:.2f} ms", found->second));
        ImGui::PopStyleColor();
    }
    row("in all", fmt::format("{:.2f} ms", totalOf(last)));
    ImGui::EndTable();
}

std::string mebibytes(std::int64_t bytes) {
    return fmt::format("{:.2f} MiB", double(bytes) / (1 << 20));
}

void memoryTable(const gl::Ledger& ledger) {
    std::vector<std::pair<std::int64_t, std::string>> kinds;
    for (const auto& [kind, bytes] : ledger.byKind())
        if (bytes > 0) kinds.emplace_back(bytes, kind);
    std::sort(kinds.rbegin(), kinds.rend());
    if (!ImGui::BeginTable("memory", 2)) return;
    row("in all", mebibytes(ledger.total()));
    row("at most", mebibytes(ledger.peak()));
    for (const auto& [bytes, kind] : kinds)
        row(kind, mebibytes(bytes));
    ImGui::EndTable();
}

void skippedTable(Stage& stage) {
    if (!ImGui::BeginTable("skipped", 2)) return;
    const Engine& engine = stage.engine();
    const bool planeless = !factsOf(engine.scene().caustics.method).planes;
    for (const MapWork& maps : engine.maps()) {
        const std::string& receiver = engine.scene().receivers[std::size_t(maps.plan.receiver)].name;
        const std::string facing =
            maps.level.facing > 0 ? fmt::format(", side map {}", maps.level.facing) : "";
        const int left = maps.level.requestedPlanes - int(maps.level.planes.size());
        row(fmt::format("{} in {}{}", receiver, engine.scene().lights[std::size_t(maps.plan.light)].name,
                        facing),
            planeless ? "needs none"
                      : fmt::format("{} of {}", std::max(left, 0), maps.level.requestedPlanes));
    }
    for (const auto& [kind, count] : engine.skipped().byKind())
        if (count > 0) row(fmt::format("skipped: {}", kind), fmt::format("{}", count));
    for (std::size_t i = 0; i < engine.scene().lights.size(); ++i)
        row(fmt::format("{}: beams", engine.scene().lights[i].name),
            fmt::format("{}", engine.light(int(i)).mapBeams().triangleCount));
    ImGui::EndTable();
}

void answersTable(Measured& measured) {
    if (!ImGui::BeginTable("answers", 2)) return;
    row("pictures a second", fmt::format("{}", measured.perSecond()));
    row("first picture", fmt::format("{:.0f} ms", measured.firstPictureMs));
    if (!measured.answersMs.empty()) {
        const Spread spread = spreadOf(measured.answersMs);
        row("a change is answered in", fmt::format("{:.0f} ms", spread.median));
        row("19 of 20 in", fmt::format("{:.0f} ms", spread.p95));
    }
    ImGui::EndTable();
}

} // namespace

void measurePanel(Measured& measured, Stage& stage, gl::Context& context) {
    ImGui::TextWrapped("%s", context.info().renderer.c_str());
    ImGui::TextDisabled("OpenGL %s", context.info().version.c_str());
    if (measured.frames.empty()) return;
    const auto names = passNames(measured);
    if (section("GPU time by pass", true)) {
        graph(measured, names);
        passTable(measured, names);
    }
    if (section("Response", true)) answersTable(measured);
    if (section("Planes left out, beams", true)) skippedTable(stage);
    if (section("GPU memory by kind", true)) memoryTable(context.ledger());
}

} // namespace limpid::viewer
