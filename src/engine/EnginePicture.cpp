#include <algorithm>
#include <cmath>

#include "engine/Engine.h"
#include "gl/Guard.h"
#include "plan/FlatWater.h"
#include "plan/MapPlan.h"
#include "plan/WaveTerms.h"
#include "view/Visibility.h"
#include "water/WaterSurface.h"

/// The half of the engine that makes pictures.
namespace limpid {

using Scope = gl::PassTimers::Scope;

/// A lamp under water makes no caustic, so only pictures need to know what it sees; that rests.
void Engine::drawLampShadows() {
    for (std::size_t i = 0; i < _lights.size(); ++i) {
        LightState& state = _lights[i];
        if ((_reuse && state.lampShadow.id()) || !isSubmerged(_scene.lights[i], _scene.water)) continue;
        if (!_lampShadowPass) _lampShadowPass = std::make_unique<LampShadowPass>(_context);
        Scope scope(_timers, "lamp shadow");
        _lampShadowPass->draw(state.lampShadow, state.beams, _receivers);
        state.beams.lampShadow = &state.lampShadow;
    }
}

/// Which maps a picture of `size` needs: those whose receiver it may show in a light that gives any.
std::vector<bool> Engine::shownMaps(glm::ivec2 size) {
    const ViewFrameData frame =
        viewFrame(_scene, _plan.origin, _plan.patch, _surface.mesh(), _plan.sides, size);
    std::vector<bool> shown;
    for (const ReceiverMaps& maps : _maps)
        shown.push_back(
            !_skipping ||
            (!isUnlit(maps) && mayShowCaustics(frame, _plan.receivers[std::size_t(maps.receiver)].bounds)));
    return shown;
}

void Engine::drawGodrays(const GodrayInputs& inputs) {
    if (!_godrayTarget) _godrayTarget = std::make_unique<GodrayTarget>(_context);
    switch (_scene.godrays.method) {
    case GodrayMethod::None:
        break;
    case GodrayMethod::PhotonLines:
        if (!_photonLines) _photonLines = std::make_unique<PhotonLines>(_context);
        _photonLines->draw(*_godrayTarget, inputs);
        break;
    case GodrayMethod::ExactShafts:
        if (!_exactShafts) _exactShafts = std::make_unique<ExactShafts>(_context);
        _exactShafts->draw(*_godrayTarget, inputs);
        break;
    case GodrayMethod::Tetrahedra:
        if (!_tetrahedra) _tetrahedra = std::make_unique<Tetrahedra>(_context);
        _tetrahedra->draw(*_godrayTarget, inputs);
        break;
    }
}

/// Null where nothing is scattered, or the camera is above.
const gl::Texture* Engine::drawGodrays(glm::ivec2 size) {
    const bool wanted = _scene.godrays.method != GodrayMethod::None;
    if (!wanted || _scene.water.scattering == glm::dvec3(0)) return nullptr;
    const ViewFrameData frame =
        viewFrame(_scene, _plan.origin, _plan.patch, _surface.mesh(), _plan.sides, size);
    if (frame.cameraAbove()) return nullptr;
    std::vector<SceneDepth> own(_lights.size()); // of lights whose maps do without one, and are to go on so
    std::vector<GodraySource> sources;
    for (std::size_t i = 0; i < _lights.size(); ++i) {
        if (isDark(int(i))) continue;
        const LightState& state = _lights[i];
        const bool there = state.sceneDepth.first.id() != 0;
        if (!there) drawSceneDepth(own[i], state, _scene.caustics.mapSize);
        sources.push_back({state.beams, there ? state.sceneDepth : own[i], _scene.lights[i], state.farthest});
    }
    if (sources.empty()) return nullptr;
    Scope scope(_timers, "godrays");
    const GodrayCamera camera{frame.viewProjection, glm::vec3(frame.cameraPosition), size};
    drawGodrays({_scene, _surface.mesh(), _plan.patch, _plan.origin, _receivers, sources, camera});
    return &_godrayTarget->radiance();
}

/// How often a map may be halved and still have the texels that a picture asks for where it shows most of
/// them.
void Engine::fitMaps(glm::ivec2 size) {
    const double perPixel = _scene.caustics.texelsPerPixel;
    if (perPixel <= 0) return;
    const double pixelsPerTangent = size.y / (2 * std::tan(0.5 * glm::radians(_scene.camera.verticalFov)));
    for (ReceiverMaps& maps : _maps) {
        const Bounds& bounds = _plan.receivers[std::size_t(maps.receiver)].bounds;
        const double radius = 0.5 * glm::length(bounds.size());
        const double away = glm::distance(*_scene.camera.position - _plan.origin, bounds.center()) - radius;
        // Water between brings things nearer by its index, at most.
        const double pixels = away > 0 ? pixelsPerTangent * 2 * radius / away * _scene.water.ior : 1e9;
        const double spare = mapSize(_scene, _plan.patch, maps.box, maps.level.facing) / (perPixel * pixels);
        const int halvings = std::clamp(int(std::floor(std::log2(std::max(spare, 1e-9)))), 0, 16);
        if (halvings == maps.halvings) continue;
        maps.halvings = halvings;
        maps.ready = maps.filled = false;
    }
}

/// The time that the caustics of a picture at `time` are of.
double Engine::causticsTime(double time) const {
    const double refresh = _scene.caustics.refresh;
    return refresh > 0 ? std::floor(time * refresh + 1e-9) / refresh : time;
}

void Engine::moveWater(double time) {
    if (!moves(_scene.water) || time == _waterTime) return;
    Scope scope(_timers, "water");
    _surface.update(_scene.water, _plan.patch, _plan.origin, time);
    _waterTime = time;
}

void Engine::updateForPictures(double time) {
    const gl::Guard guard(_context);
    updateCaustics(causticsTime(time));
    moveWater(time);
}

Picture Engine::render(double time, glm::ivec2 size) {
    const gl::Guard guard(_context);
    updateSurface(causticsTime(time));
    fitMaps(size);
    const std::vector<bool> shown = shownMaps(size);
    for (std::size_t i = 0; i < _maps.size(); ++i) {
        if (shown[i])
            updateMaps(_maps[i]);
        else
            ++(isUnlit(_maps[i]) ? _skipped.unlitMaps : _skipped.outOfView);
    }
    moveWater(time);
    return draw(size);
}

/// Where maps were freed and no update came, the last one's are made anew.
void Engine::remakeFreed() {
    if (_causticsTime) return;
    const double time = _waterTime;
    updateSurface(causticsTime(time));
    moveWater(time);
}

/// Calls `use` with the picture pass and its inputs for a picture of `size`; `goesOn`: one that was begun
/// before.
template <typename Use>
auto Engine::withPicture(glm::ivec2 size, bool goesOn, Use&& use) try {
    remakeFreed();
    fitMaps(size);
    const std::vector<bool> shown = shownMaps(size);
    std::vector<Lit> lit;
    for (std::size_t i = 0; i < _maps.size(); ++i) {
        ReceiverMaps& maps = _maps[i];
        if (!shown[i]) continue;
        if (!maps.filled) updateMaps(maps);
        lit.push_back({maps.receiver, &maps.level, &maps.caustics});
    }
    drawLampShadows();
    if (!goesOn) _godrays = drawGodrays(size);
    if (!_picturePass) _picturePass = std::make_unique<PicturePass>(_context);
    Scope scope(_timers, "picture");
    std::vector<const Beams*> lights;
    for (const LightState& state : _lights)
        lights.push_back(&state.beams);
    const bool rests = _reuse && _pictureHasLight;
    _pictureHasLight = true;
    // That make maps ready to be projected.
    if (!goesOn) _skipped.unreadPasses += std::int64_t(_maps.size() - lit.size());
    return use(*_picturePass, PicturePass::Inputs{_scene, _plan.origin, _plan.patch, _surface.mesh(),
                                                  _plan.sides, _receivers, lit, lights, _godrays, rests});
} catch (...) {
    freeMaps();
    throw;
}

Picture Engine::draw(glm::ivec2 size) {
    const gl::Guard guard(_context);
    return withPicture(size, false,
                       [&](PicturePass& pass, const auto& inputs) { return pass.draw(inputs, size); });
}

PicturePass::Sketch Engine::beginPicture(glm::ivec2 size, int perPixel) {
    const gl::Guard guard(_context);
    return withPicture(size, false, [&](PicturePass& pass, const auto& inputs) {
        return pass.begin(inputs, size, perPixel);
    });
}

void Engine::drawRows(const PicturePass::Sketch& sketch, glm::ivec2 rows) {
    const gl::Guard guard(_context);
    withPicture(sketch.samples().size() / sketch.perPixel(), true,
                [&](PicturePass& pass, const auto& inputs) { pass.drawRows(inputs, sketch, rows); });
}

} // namespace limpid
