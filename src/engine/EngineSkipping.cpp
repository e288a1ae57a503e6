#include "engine/Engine.h"
#include "scene/MethodFacts.h"

/// What the engine leaves out, and how it counts that.
namespace limpid {

/// Whether nothing comes of a light.
bool Engine::isDark(int light) const {
    return _lights[std::size_t(light)].beams.strength == glm::dvec3(0);
}

/// Whether no light comes to a map.
bool Engine::isUnlit(const ReceiverMaps& maps) const {
    return isDark(maps.light) || !maps.inReach;
}

bool Engine::cullsBeams() const {
    return _skipping && sumsBeams(_scene.caustics);
}

/// Null where all beams are to be asked.
const BeamCulling* Engine::cullBeams(ReceiverMaps& maps, const BeamTiles& tiles) {
    if (!cullsBeams()) return nullptr;
    const bool exact = factsOf(_scene.caustics.method).tangentPlanes;
    _culling.cull(tiles, maps.level, exact ? maps.tangents.depthPyramid : maps.depths.pyramid,
                  exact ? BeamCulling::Depths::Leaning : BeamCulling::Depths::Planes);
    if (!maps.askedBeams.id()) maps.askedBeams = gl::Buffer(_context.ledger(), "beam tiles", 4);
    maps.askedBeams.copy(_culling.kept(), BeamCulling::beamCountOffset, sizeof(std::uint32_t));
    maps.culled = true;
    return &_culling;
}

/// What filling a map leaves out by its settings.
void Engine::countSkipped(const ReceiverMaps& maps) {
    if (!_skipping) return;
    const CausticsSettings& settings = _scene.caustics;
    const int all = maps.level.frame.flat ? 1 : maps.level.requestedPlanes;
    if (factsOf(settings.method).slicing && settings.slicing == Slicing::Automatic)
        _skipped.planes += all - int(maps.level.planes.size());
    if (fillOf(settings.method, settings.fill) == Fill::OnePass)
        _skipped.channels += 3 - channelsOf(Colours::AsNeeded, _scene.water);
}

Skipped Engine::skipped() const {
    Skipped skipped = _skipped;
    for (const ReceiverMaps& maps : _maps) {
        if (!maps.culled) continue;
        const auto asked = maps.askedBeams.read<std::uint32_t>(1).front();
        skipped.beams += _lights[std::size_t(maps.light)].mapBeams().triangleCount - std::int64_t(asked);
        if (asked == 0) ++skipped.unlitMaps;
    }
    return skipped;
}

std::int64_t Engine::beamsDrawn(int light) const {
    const LightState& state = _lights[std::size_t(light)];
    if (_skipping && isDark(light)) return 0;
    return state.tiles.quads == glm::ivec2(0) ? state.mapBeams().triangleCount : state.tiles.reachedBeams();
}

} // namespace limpid
