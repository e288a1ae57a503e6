#include "engine/Engine.h"
#include "view/Visibility.h"
#include "water/FlatWater.h"

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
    const ViewFrameData frame = viewFrame(_scene, _origin, _patch, _surface.mesh(), _sides, size);
    std::vector<bool> shown;
    for (const ReceiverMaps& maps : _maps)
        shown.push_back(!_skipping ||
                        (!isUnlit(maps) && mayShowCaustics(frame, _bounds[std::size_t(maps.receiver)])));
    return shown;
}

/// Null where nothing is scattered, or not by a method that is there; seen from above, likewise.
const gl::Texture* Engine::drawGodrays(glm::ivec2 size) {
    const bool wanted = _scene.godrays.method == GodrayMethod::PhotonLines;
    if (!wanted || _scene.water.scattering == glm::dvec3(0)) return nullptr;
    const ViewFrameData frame = viewFrame(_scene, _origin, _patch, _surface.mesh(), _sides, size);
    if (frame.cameraAbove()) return nullptr;
    std::vector<SceneDepth> own(_lights.size()); // of lights whose maps do without one, and are to go on so
    std::vector<PhotonLines::Source> sources;
    for (std::size_t i = 0; i < _lights.size(); ++i) {
        if (isDark(int(i))) continue;
        LightState& state = _lights[i];
        const bool there = state.sceneDepth.first.id() != 0;
        if (!there) {
            drawSceneDepth(int(i));
            own[i] = std::move(state.sceneDepth);
            state.sceneDepth = {};
        }
        sources.push_back({state.beams, there ? state.sceneDepth : own[i], state.farthest});
    }
    if (!_photonLines) _photonLines = std::make_unique<PhotonLines>(_context);
    Scope scope(_timers, "godrays");
    const PhotonLines::Camera camera{frame.viewProjection, glm::vec3(frame.cameraPosition), size};
    return &_photonLines->draw({_scene, _surface.mesh(), _patch, _origin, _receivers, sources, camera});
}

Picture Engine::render(double time, glm::ivec2 size) {
    updateSurface(time);
    const std::vector<bool> shown = shownMaps(size);
    for (std::size_t i = 0; i < _maps.size(); ++i) {
        if (shown[i])
            updateMaps(_maps[i]);
        else
            ++(isUnlit(_maps[i]) ? _skipped.unlitMaps : _skipped.outOfView);
    }
    return draw(size);
}

/// Calls `use` with the picture pass and its inputs for a picture of `size`.
template <typename Use>
auto Engine::withPicture(glm::ivec2 size, Use&& use) {
    const std::vector<bool> shown = shownMaps(size);
    std::vector<Lit> lit;
    for (std::size_t i = 0; i < _maps.size(); ++i) {
        ReceiverMaps& maps = _maps[i];
        if (!shown[i]) continue;
        if (!maps.filled) updateMaps(maps);
        lit.push_back({maps.receiver, &maps.level, &maps.caustics});
    }
    drawLampShadows();
    const gl::Texture* godrays = drawGodrays(size);
    if (!_picturePass) _picturePass = std::make_unique<PicturePass>(_context);
    Scope scope(_timers, "picture");
    std::vector<const Beams*> lights;
    for (const LightState& state : _lights)
        lights.push_back(&state.beams);
    const bool rests = _reuse && _pictureHasLight;
    _pictureHasLight = true;
    _skipped.unreadPasses += std::int64_t(_maps.size() - lit.size()); // that make maps ready to be projected
    return use(*_picturePass, PicturePass::Inputs{_scene, _origin, _patch, _surface.mesh(), _sides,
                                                  _receivers, lit, lights, godrays, rests});
}

Picture Engine::draw(glm::ivec2 size) {
    return withPicture(size, [&](PicturePass& pass, const auto& inputs) { return pass.draw(inputs, size); });
}

PicturePass::Sketch Engine::beginPicture(glm::ivec2 size, int perPixel) {
    return withPicture(
        size, [&](PicturePass& pass, const auto& inputs) { return pass.begin(inputs, size, perPixel); });
}

void Engine::drawRows(const PicturePass::Sketch& sketch, glm::ivec2 rows) {
    withPicture(sketch.samples().size() / sketch.perPixel(),
                [&](PicturePass& pass, const auto& inputs) { pass.drawRows(inputs, sketch, rows); });
}

} // namespace limpid
