#include "apps/viewer/Understanding.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <imgui.h>

#include "apps/viewer/Overlay.h"
#include "apps/viewer/Pick.h"
#include "apps/viewer/Widgets.h"
#include "engine/Readback.h"
#include "scene/MethodFacts.h"

namespace limpid::viewer {

namespace {

constexpr ImU32 boxColor = IM_COL32(255, 205, 90, 230), keptColor = IM_COL32(110, 220, 255, 150),
                droppedColor = IM_COL32(255, 90, 90, 70), beamColor = IM_COL32(255, 240, 170, 170);
constexpr int mostBeams = 60;

void drawPlane(const Overlay& overlay, const OrientedBox& box, double depth, ImU32 color) {
    const glm::dvec2 corners[] = {{0, 0}, {box.extent.x, 0}, {box.extent.x, box.extent.y}, {0, box.extent.y}};
    for (int i = 0; i < 4; ++i)
        overlay.line(box.point({corners[i], depth}), box.point({corners[(i + 1) % 4], depth}), color);
}

void drawBox(const Overlay& overlay, const OrientedBox& box) {
    drawPlane(overlay, box, 0, boxColor);
    drawPlane(overlay, box, box.extent.z, boxColor);
    for (const glm::dvec2 corner : {glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(1, 1), glm::dvec2(0, 1)}) {
        const glm::dvec2 at = corner * glm::dvec2(box.extent);
        overlay.line(box.point({at, 0}), box.point({at, box.extent.z}), boxColor);
    }
}

/// Kept planes bright, dropped ones red.
void drawPlanes(const Overlay& overlay, const MapWork& maps) {
    const auto& kept = maps.level.planes;
    const OrientedBox& box = maps.level.frame.box;
    for (const ReferencePlane& plane : uniformPlanes(box.extent.z, maps.level.requestedPlanes)) {
        const bool drawn = std::any_of(kept.begin(), kept.end(), [&](const ReferencePlane& k) {
            return std::abs(k.depth - plane.depth) <= 1e-9 * box.extent.z;
        });
        if (!drawn) drawPlane(overlay, box, plane.depth, droppedColor);
    }
    for (const ReferencePlane& plane : kept)
        drawPlane(overlay, box, plane.depth, keptColor);
}

/// The side of a square image that fits twice into the panel.
float imageSide() {
    return 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
}

void imageOf(const MapImages& images, MapImages::Kind kind, const char* name, float side) {
    const gl::Texture& texture = images.image(kind);
    const glm::vec2 pixels(images.size()), used = pixels / glm::vec2(texture.size());
    const ImVec2 end(used.x, used.y);
    const ImTextureID id = reinterpret_cast<ImTextureID>(std::uintptr_t(texture.id()));
    const glm::vec2 size = pixels * (side / std::max(pixels.x, pixels.y));
    ImGui::BeginGroup();
    ImGui::TextUnformatted(name);
    ImGui::Image(id, ImVec2(size.x, size.y), ImVec2(0, 0), end);
    if (ImGui::IsItemHovered()) {
        ImGui::BeginTooltip();
        const float scale = 2.5f;
        ImGui::Image(id, ImVec2(scale * size.x, scale * size.y), ImVec2(0, 0), end);
        ImGui::EndTooltip();
    }
    ImGui::EndGroup();
}

} // namespace

const MapWork* Understanding::shownMaps(const State& state, Stage& stage) const {
    if (!stage.hasScene() || !state.selected) return nullptr;
    const MapWork* first = nullptr;
    for (const MapWork& maps : stage.engine().maps()) {
        if (maps.plan.receiver != *state.selected || maps.plan.light != state.light ||
            !maps.caustics.irradiance.id())
            continue;
        if (maps.level.facing == _facing) return &maps;
        if (!first) first = &maps;
    }
    return first;
}

void Understanding::update(const State& state, Stage& stage, bool changed) {
    _stale = _stale || changed || _selected != state.selected;
    _beamsStale = _beamsStale || changed || _selected != state.selected;
    _selected = state.selected;
    const MapWork* maps = shownMaps(state, stage);
    const bool panel = state.panels && state.side == State::Side::Understand;
    if (panel && maps && (_stale || maps != _maps)) {
        if (!_images) _images = std::make_unique<MapImages>(_context);
        const glm::dvec3 strength = stage.engine().light(maps->plan.light).beams.strength;
        const double brightest = std::max({strength.x, strength.y, strength.z, 1e-9});
        // Light as under flat water comes out at a third of the scale: caustics have room above it.
        _images->update(*maps, 0.5 / brightest);
        if (stage.rests() || maps != _maps) _histogram = planeHistogram(maps->level);
        _stale = !stage.rests();
    }
    _maps = maps;
    if (state.beams && _beamsStale && stage.rests()) {
        traceBeams(state, stage);
        _beamsStale = false;
    }
}

/// Some of the beams that reach the picked receiver (any, if none is picked), up to what they meet.
void Understanding::traceBeams(const State& state, Stage& stage) {
    _beams.clear();
    Engine& engine = stage.engine();
    if (state.light >= int(state.scene.lights.size())) return;
    const Beams& beams = engine.light(state.light).beams;
    if (beams.vertexCount < 1 || beams.strength == glm::dvec3(0)) return;
    const auto origins = beams.origins.read<glm::vec4>(std::size_t(beams.vertexCount));
    const auto directions = beams.directions.read<glm::vec4>(std::size_t(beams.vertexCount));
    Bounds bounds;
    for (std::size_t i = 0; i < state.scene.receivers.size(); ++i)
        if (!state.selected || int(i) == *state.selected) bounds = worldBounds(state.scene.receivers[i]);
    if (!state.selected) bounds = worldBounds(state.scene);
    const double radius = 0.5 * glm::length(bounds.size());
    // An even spread of the grid's corners, from all over it in any order (golden ratio).
    const std::size_t count = origins.size();
    for (std::size_t i = 0; i < std::min<std::size_t>(count, 4000) && int(_beams.size()) < mostBeams; ++i) {
        const double share = 0.6180339887498949 * double(i);
        const auto at = std::size_t((share - std::floor(share)) * double(count));
        const Ray ray{glm::dvec3(origins[at]) + engine.origin(), glm::dvec3(directions[at])};
        const glm::dvec3 toMiddle = bounds.center() - ray.origin;
        if (glm::length(glm::cross(toMiddle, ray.direction)) > radius) continue;
        const auto hit = firstAlong(state.scene, ray, 1e6);
        if (!hit || (state.selected && hit->receiver != *state.selected)) continue;
        _beams.push_back({ray.origin, hit->point});
    }
}

void Understanding::overlay(const State& state, Stage& stage, const Area& picture) const {
    if (!stage.hasScene() || !stage.display()) return;
    const Overlay lines(state.scene, picture);
    for (const MapWork& maps : stage.engine().maps()) {
        if (state.selected && maps.plan.receiver != *state.selected) continue;
        if (maps.plan.light != state.light || maps.level.facing > 0 || !maps.caustics.irradiance.id())
            continue;
        if (state.boxes) drawBox(lines, maps.level.frame.box);
        if (state.planes && state.selected) drawPlanes(lines, maps);
    }
    if (state.beams)
        for (const auto& beam : _beams)
            lines.line(beam.front(), beam.back(), beamColor);
}

void Understanding::mapChoice(State& state, Stage& stage) {
    if (state.scene.lights.size() > 1) {
        if (ImGui::BeginCombo("light", state.scene.lights[std::size_t(state.light)].name.c_str())) {
            for (std::size_t i = 0; i < state.scene.lights.size(); ++i)
                if (ImGui::Selectable(state.scene.lights[i].name.c_str())) state.light = int(i);
            ImGui::EndCombo();
        }
    }
    int further = 0;
    for (const MapWork& maps : stage.engine().maps())
        if (state.selected == maps.plan.receiver && maps.plan.light == state.light)
            further = std::max(further, maps.level.facing);
    if (further == 0) return;
    ImGui::SliderInt("map", &_facing, 0, further, _facing == 0 ? "along the light" : "side map %d");
}

/// Texels by reference plane; planes that are left out, and those that are drawn.
void Understanding::histogram(const MapWork& maps) const {
    if (_histogram.empty()) return;
    const float most = float(std::max(*std::max_element(_histogram.begin(), _histogram.end()), 1u));
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const ImVec2 size(ImGui::GetContentRegionAvail().x, 6 * ImGui::GetFontSize());
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddRectFilled(from, ImVec2(from.x + size.x, from.y + size.y), IM_COL32(20, 22, 26, 255));
    const float width = size.x / float(_histogram.size());
    for (std::size_t i = 0; i < _histogram.size(); ++i) {
        const bool kept = std::any_of(maps.level.planes.begin(), maps.level.planes.end(),
                                      [&](const ReferencePlane& p) { return p.index == int(i); });
        const float x = from.x + width * float(i), gap = width > 4 ? 1.0f : 0.0f;
        const float tall =
            _histogram[i] > 0 ? std::max(size.y * std::sqrt(float(_histogram[i]) / most), 2.0f) : 0;
        list->AddRectFilled(ImVec2(x, from.y + size.y - tall), ImVec2(x + width - gap, from.y + size.y),
                            kept ? IM_COL32(110, 200, 240, 255) : IM_COL32(220, 110, 90, 255));
        if (!kept)
            list->AddRectFilled(ImVec2(x, from.y),
                                ImVec2(x + width - gap, from.y + 0.25f * ImGui::GetFontSize()),
                                IM_COL32(220, 90, 80, 255));
    }
    ImGui::Dummy(size);
    widgets::hint("texels by reference plane, near the light on the left; square roots. Red above: left out");
}

void Understanding::panel(State& state, Stage& stage) {
    ImGui::PushItemWidth(-0.3f * ImGui::GetContentRegionAvail().x);
    if (!state.selected) {
        ImGui::TextWrapped("Pick a receiver: click it in the picture or in the list.");
    } else {
        const Receiver& receiver = state.scene.receivers[std::size_t(*state.selected)];
        ImGui::Text("Level map of %s", receiver.name.c_str());
        mapChoice(state, stage);
        if (_images && _maps) {
            const glm::ivec2 size = _maps->level.frame.size;
            ImGui::TextDisabled("%d x %d texels of %.3g mm", size.x, size.y, 1000 * _maps->level.frame.texel);
            const float side = imageSide();
            imageOf(*_images, MapImages::Position, "position", side);
            ImGui::SameLine();
            imageOf(*_images, MapImages::Diffuse, "diffuse", side);
            imageOf(*_images, MapImages::Normal, "normal", side);
            ImGui::SameLine();
            imageOf(*_images, MapImages::Caustic, "caustic", side);
            ImGui::Text("Depth histogram: %zu of %d planes drawn", _maps->level.planes.size(),
                        _maps->level.requestedPlanes);
            histogram(*_maps);
            if (!factsOf(state.scene.caustics.method).planes)
                ImGui::TextDisabled("this method has no need of planes");
        } else {
            ImGui::TextWrapped("It has no map: it does not reach into lit water.");
        }
    }
    ImGui::Separator();
    ImGui::Text("In the picture");
    ImGui::Checkbox("its box along the light (B)", &state.boxes);
    ImGui::Checkbox("its reference planes (G)", &state.planes);
    widgets::hint("blue: drawn; red: left out");
    ImGui::Checkbox("some beams that reach it (R)", &state.beams);
    ImGui::PopItemWidth();
}

} // namespace limpid::viewer
