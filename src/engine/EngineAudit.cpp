#include "engine/Engine.h"

#include <algorithm>

/// Counting where the light went, after a frame.
namespace limpid {

namespace {

using Scope = gl::PassTimers::Scope;

/// The map size whose scene depth map light is counted by, at least.
constexpr int auditMapSize = 1024;

} // namespace

gl::Texture Engine::coverage(const ReceiverMaps& maps) {
    if (!_coveragePass) _coveragePass = std::make_unique<CoveragePass>(_context);
    return _coveragePass->draw(maps.level, _receivers[std::size_t(maps.receiver)],
                               _lights[std::size_t(maps.light)].beams);
}

FluxBalance Engine::auditFlux(int index) try {
    const LightState& state = _lights[std::size_t(index)];
    if (state.beams.strength == glm::dvec3(0)) return {};
    // Rims are told by texels' middles. That may put a floor's four all outwards or all inwards: with the
    // methods' own map, which at 256 is 512 wide, 0.4 % of its light.
    SceneDepth sceneDepth;
    drawSceneDepth(sceneDepth, state, std::max(_scene.caustics.mapSize, auditMapSize));
    std::vector<gl::Texture> coverages;
    std::vector<FluxAudit::Placed> levels;
    for (const ReceiverMaps& maps : _maps)
        if (maps.light == index) {
            coverages.push_back(coverage(maps));
            levels.push_back({maps.receiver, &maps.level, nullptr});
        }
    for (std::size_t i = 0; i < levels.size(); ++i)
        levels[i].coverage = &coverages[i];
    Scope scope(_timers, "flux audit");
    return _fluxAudit.count(
        state.mapBeams(), mapMesh(state), _scene.water, sceneDepth, levels, state.farthest,
        goesOwnWay(_scene.caustics.method) ? FluxAudit::Shade::Own : FluxAudit::Shade::Mean);
} catch (...) {
    freeMaps();
    throw;
}

} // namespace limpid
