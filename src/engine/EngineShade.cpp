#include "engine/Engine.h"

#include <algorithm>

#include "plan/FlatWater.h"
#include "scene/MethodFacts.h"

/// What stands in light's way, and what of it a method asks.
namespace limpid {

namespace {

using Scope = gl::PassTimers::Scope;

/// As texelFrame has it.
bool isFlat(const OrientedBox& box) {
    return box.extent.z <= 1e-4 * std::max(box.extent.x, box.extent.y);
}

glm::ivec2 sceneDepthSize(const glm::vec4& rect, int mapSize) {
    // Twice the receivers' own resolution, so that shadow edges are theirs and not this map's.
    const int longer = std::clamp(2 * mapSize, 256, 4096);
    const float most = std::max(rect.z, rect.w);
    return glm::max(glm::ivec2(glm::ceil(glm::vec2(rect.z, rect.w) / most * float(longer))), 1);
}

} // namespace

bool Engine::hasFurtherMaps(int light) const {
    return std::any_of(_maps.begin(), _maps.end(),
                       [&](const ReceiverMaps& m) { return m.light == light && m.level.facing > 0; });
}

/// A receiver alone shades itself within its own map, unless a lamp sees it from other sides than the box
/// does, or a further map looks from elsewhere.
bool Engine::needsSceneDepth(int index) const {
    const Light& light = _scene.lights[std::size_t(index)];
    if (factsOf(_scene.caustics.method).occludesPerBeam || !entersWater(light, _scene.water)) return false;
    return _receivers.size() > 1 || light.type == LightType::Point || hasFurtherMaps(index);
}

/// Beams that go their own ways may meet anything but a plane that is alone; the mean light's shade lacks
/// what lets a part of it through.
bool Engine::needsOccluders(int index) const {
    const Light& light = _scene.lights[std::size_t(index)];
    if (!entersWater(light, _scene.water)) return false;
    if (!factsOf(_scene.caustics.method).occludesPerBeam) return hasTranslucents();
    return _receivers.size() > 1 || hasFurtherMaps(index) ||
           std::any_of(_maps.begin(), _maps.end(), [](const ReceiverMaps& m) { return !isFlat(m.box); });
}

void Engine::drawSceneDepth(SceneDepth& depth, const LightState& state, int mapSize) {
    Scope scope(_timers, "scene depth map");
    _sceneDepthPass.draw(depth, sceneDepthSize(state.beams.rect, mapSize),
                         {state.beams, _receivers, state.farthest});
}

bool Engine::hasTranslucents() const {
    return std::any_of(_receivers.begin(), _receivers.end(),
                       [](const ReceiverGeometry& receiver) { return receiver.translucent(); });
}

/// Beams that go their own way are asked about sheets one by one; the mean light here.
void Engine::updateTakenLight(ReceiverMaps& maps) {
    const bool shaded = _occluders && !factsOf(_scene.caustics.method).occludesPerBeam && hasTranslucents();
    if (!_receivers[std::size_t(maps.receiver)].translucent() && !shaded) return;
    if (!_takenLight) _takenLight = std::make_unique<TakenLight>(_context);
    Scope scope(_timers, "taken light");
    maps.taken = _takenLight->opacity(maps.level, litReceiver(maps));
    if (shaded) _takenLight->shade(maps.taken, maps.level, litReceiver(maps), *_occluders);
}

const SceneDepth* Engine::sceneDepthOf(const ReceiverMaps& maps) const {
    const SceneDepth& sceneDepth = _lights[std::size_t(maps.light)].sceneDepth;
    return sceneDepth.first.id() ? &sceneDepth : nullptr;
}

bool Engine::needsOccluders() const {
    for (int light = 0; light < int(_lights.size()); ++light)
        if (needsOccluders(light)) return true;
    return false;
}

const Occluders* Engine::occludersOf(const ReceiverMaps& maps) const {
    return needsOccluders(maps.light) ? _occluders.get() : nullptr;
}

} // namespace limpid
