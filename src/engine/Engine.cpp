#include "engine/Engine.h"

#include <algorithm>
#include <cmath>

#include "engine/Limits.h"
#include "gl/Guard.h"
#include "plan/FlatWater.h"
#include "plan/Framing.h"
#include "plan/MapPlan.h"
#include "plan/SunDisc.h"
#include "plan/WaveTerms.h"
#include "scene/MethodFacts.h"

namespace limpid {

using Scope = gl::PassTimers::Scope;

Engine::Engine(gl::Context& context)
    : _context(context), _surface(context), _beamTracer(context), _sceneDepthPass(context),
      _surfaceShadowPass(context), _levelMapPass(context), _smartSlicing(context),
      _tangentPlanesPass(context), _planeDepthsPass(context), _drawnPlanes(context), _planeBeams(context),
      _culling(context), _exactBeams(context), _discFilter(context) {}

void Engine::requireScene(const Scene& scene, const gl::Context& context) {
    requireGrid(scene.water.grid, context.info());
    requirePlanes(scene.caustics, context.info());
}

void Engine::setScene(Scene scene) {
    scene.camera = framedCamera(scene);
    requireScene(scene, _context);
    const gl::Guard guard(_context);
    Plan plan = planOf(scene);
    uploadReceivers(scene, plan.origin);
    _plan = std::move(plan);
    _scene = std::move(scene);
    _maps.clear();
    freeMaps();
    for (const PlannedMap& planned : _plan.maps) {
        ReceiverMaps& maps = _maps.emplace_back();
        maps.light = planned.light;
        maps.receiver = planned.receiver;
        maps.facings = planned.facings;
        maps.box = planned.box;
        maps.gradients = planned.gradients;
        maps.level.facing = planned.facing;
        maps.inReach = planned.inReach;
    }
}

/// Those of the scene before that come again are not made again, and all of them stay until the others are
/// there.
void Engine::uploadReceivers(const Scene& scene, const glm::dvec3& origin) {
    std::vector<std::optional<ReceiverGeometry>> made(scene.receivers.size());
    for (std::size_t i = 0; i < made.size(); ++i) {
        const bool same =
            i < _receivers.size() && origin == _plan.origin && scene.receivers[i] == _scene.receivers[i];
        if (!same) made[i].emplace(_context, scene.receivers[i], origin);
    }
    const bool sameAll = made.size() == _receivers.size() &&
                         std::none_of(made.begin(), made.end(), [](const auto& m) { return m.has_value(); });
    if (!sameAll) _occluders.reset();
    std::vector<ReceiverGeometry> receivers;
    for (std::size_t i = 0; i < made.size(); ++i)
        receivers.push_back(std::move(made[i] ? *made[i] : _receivers[i]));
    _receivers = std::move(receivers);
}

void Engine::setLook(const Scene& scene) {
    _scene.camera = scene.camera;
    _scene.skyRadiance = scene.skyRadiance;
    _scene.ambientRadiance = scene.ambientRadiance;
    _scene.godrays = scene.godrays;
    _scene.camera = framedCamera(_scene);
}

void Engine::setCaustics(const CausticsSettings& settings) {
    requirePlanes(settings, _context.info());
    _scene.caustics = settings;
    freeMaps();
}

/// Keeps which maps there are, and nothing of theirs on the GPU.
void Engine::freeMaps() {
    for (ReceiverMaps& maps : _maps) {
        ReceiverMaps empty;
        empty.receiver = maps.receiver;
        empty.light = maps.light;
        empty.facings = std::move(maps.facings);
        empty.box = maps.box;
        empty.inReach = maps.inReach;
        empty.gradients = maps.gradients;
        empty.level.facing = maps.level.facing;
        maps = std::move(empty);
    }
    _lights.clear();
    _lights.resize(_scene.lights.size());
    _drawnPlanes.free();
    _planeBeams.free();
    _culling.free();
    _exactBeams.free();
    _discFilter.free();
    if (_volumetric) _volumetric->free();
    if (_stencil) _stencil->free();
    if (_photonSplat) _photonSplat->free();
    _lightsReady = false;
    _causticsTime.reset();
    _pictureHasLight = false;
}

void Engine::updateCaustics(double time) {
    const gl::Guard guard(_context);
    updateSurface(time);
    for (ReceiverMaps& maps : _maps)
        updateMaps(maps);
}

/// Water, and what becomes of every light in it. This, updateMaps and withPicture leave nothing
/// half-made when the GPU runs out of memory: it would be taken for whole at the next update.
void Engine::updateSurface(double time) try {
    _skipped = {};
    for (ReceiverMaps& maps : _maps)
        maps.culled = false;
    const bool rests =
        _reuse && _causticsTime && !isLive(_scene.water) && (*_causticsTime == time || !moves(_scene.water));
    if (rests) return;
    _causticsTime = time;
    _pictureHasLight = false;
    {
        Scope scope(_timers, "water");
        _surface.update(_scene.water, _plan.patch, _plan.origin, time);
        _waterTime = time;
    }
    for (int light = 0; light < int(_lights.size()) && !(_reuse && _lightsReady); ++light)
        updateLight(light);
    _lightsReady = true;
    if (!needsOccluders()) _occluders.reset();
    traceBeams();
    for (ReceiverMaps& maps : _maps)
        maps.filled = false;
} catch (...) {
    freeMaps();
    throw;
}

void Engine::traceBeams() {
    for (std::size_t i = 0; i < _lights.size(); ++i) {
        LightState& state = _lights[i];
        if (_skipping && isDark(int(i))) {
            ++_skipped.lights;
            continue;
        }
        Scope scope(_timers, "beams");
        _beamTracer.trace(state.beams, _surface.mesh(),
                          state.surfaceShadow.id() ? &state.surfaceShadow : nullptr);
        traceLampWater(state);
        if (cullsBeams()) _culling.update(state.tiles, state.mapBeams(), mapMesh(state));
        for (DiscPoint& point : state.disc) {
            _beamTracer.trace(point.beams, _surface.mesh(), state.beams.surfaceShadow);
            if (cullsBeams()) _culling.update(point.tiles, point.beams, _surface.mesh());
        }
    }
}

void Engine::updateMaps(ReceiverMaps& maps) try {
    if (_reuse && maps.ready)
        ++_skipped.levelMaps;
    else
        updateReceiver(maps);
    maps.ready = true;
    if (_reuse && maps.filled)
        ++_skipped.causticMaps;
    else
        fill(maps), _pictureHasLight = false;
    maps.filled = true;
} catch (...) {
    freeMaps();
    throw;
}

void Engine::updateLight(int index) {
    const Light& light = _scene.lights[std::size_t(index)];
    LightState& state = _lights[std::size_t(index)];
    const LightFrameData& frame = _plan.lights[std::size_t(index)].frame;
    state.farthest = _plan.lights[std::size_t(index)].farthest;
    _beamTracer.prepare(state.beams, _surface.mesh(), light, _scene.water, frame);
    prepareDisc(index, frame);
    prepareLampWater(index, frame);
    if (frame.surfaceShadowRect.z > 0) {
        Scope scope(_timers, "surface shadow");
        _surfaceShadowPass.draw(state.surfaceShadow, state.beams, _receivers);
    }
    state.sceneDepth = {};
    if (needsSceneDepth(index)) drawSceneDepth(state.sceneDepth, state, _scene.caustics.mapSize);
    if (needsOccluders(index) && !_occluders) {
        Scope scope(_timers, "occluders");
        _occluders = std::make_unique<Occluders>(_context, _scene.receivers, _plan.origin);
    }
}

/// The other points of a disc look at what the middle does: they differ in where their rays come from alone.
void Engine::prepareDisc(int index, const LightFrameData& middle) {
    const Light& light = _scene.lights[std::size_t(index)];
    std::vector<DiscPoint>& disc = _lights[std::size_t(index)].disc;
    disc.clear();
    if (!sumsBeams(_scene.caustics)) return;
    const std::vector<Light> points = discPoints(light);
    for (std::size_t i = 1; i < points.size(); ++i) {
        LightFrameData frame = middle;
        frame.direction = glm::vec4(glm::normalize(points[i].direction), 0);
        _beamTracer.prepare(disc.emplace_back().beams, _surface.mesh(), points[i], _scene.water, frame);
    }
}

/// What a method needs to know of a receiver.
void Engine::updateReceiver(ReceiverMaps& maps) {
    switch (_scene.caustics.method) {
    case Method::LevelMap:
    case Method::Stencil:
        drawLevelMap(maps);
        updatePlaneDepths(maps);
        break;
    case Method::LevelMapSmart:
        drawLevelMap(maps);
        slice(maps.level);
        updatePlaneDepths(maps);
        break;
    case Method::ExactBeam:
    case Method::PhotonSplat:
        drawLevelMap(maps);
        updateTangentPlanes(maps);
        break;
    case Method::Volumetric:
        drawSlices(maps);
        break;
    }
    if (!factsOf(_scene.caustics.method).sliceImages) updateTakenLight(maps);
}

void Engine::prepareMaps(ReceiverMaps& maps) {
    const int size = mapSize(_scene, _plan.patch, maps.box, maps.level.facing);
    const int planes = _scene.caustics.planes;
    prepareLevelMap(_context, maps.level,
                    {maps.box, *maps.facings, maps.gradients,
                     std::max(size >> maps.halvings, std::min(size, 16)),
                     std::max(planes >> maps.halvings, std::min(planes, 3)), _plan.origin});
}

LitReceiver Engine::litReceiver(const ReceiverMaps& maps) const {
    const SceneDepth* sceneDepth = sceneDepthOf(maps);
    // Alone and seen along the light, a receiver has nothing before it but itself.
    const bool alone = maps.level.facing == 0 && _receivers.size() == 1 &&
                       _scene.lights[std::size_t(maps.light)].type == LightType::Directional;
    return {_receivers[std::size_t(maps.receiver)], maps.receiver, _lights[std::size_t(maps.light)].beams,
            sceneDepth && !alone ? &sceneDepth->first : nullptr};
}

void Engine::drawLevelMap(ReceiverMaps& maps) {
    Scope scope(_timers, "level map");
    prepareMaps(maps);
    _levelMapPass.draw(maps.level, litReceiver(maps));
}

void Engine::updateTangentPlanes(ReceiverMaps& maps) {
    if (_skipping && isUnlit(maps)) {
        ++_skipped.unreadPasses;
        return;
    }
    Scope scope(_timers, "tangent planes");
    const Occluders* occluders = factsOf(_scene.caustics.method).tangentPlanes ? occludersOf(maps) : nullptr;
    std::optional<TangentPlanesPass::Rims> rims;
    if (occluders)
        rims.emplace(
            TangentPlanesPass::Rims{*occluders, _lights[std::size_t(maps.light)].beams, maps.receiver});
    _tangentPlanesPass.update(maps.tangents, maps.level, rims ? &*rims : nullptr);
}

void Engine::updatePlaneDepths(ReceiverMaps& maps) {
    const CausticsSettings& settings = _scene.caustics;
    if (factsOf(settings.method).fills && settings.fill == Fill::Drawn) return;
    if (_skipping && isUnlit(maps)) {
        ++_skipped.unreadPasses;
        return;
    }
    Scope scope(_timers, "plane depths");
    _planeDepthsPass.update(maps.depths, maps.level);
}

void Engine::drawSlices(ReceiverMaps& maps) {
    Scope scope(_timers, "slice images");
    if (!_volumetric) _volumetric = std::make_unique<Volumetric>(_context);
    prepareMaps(maps);
    _volumetric->drawSlices(maps.slices, maps.level, litReceiver(maps));
}

gl::Texture Engine::coverage(const ReceiverMaps& maps) {
    const gl::Guard guard(_context);
    Scope scope(_timers, "coverage");
    if (!_coveragePass) _coveragePass = std::make_unique<CoveragePass>(_context);
    return _coveragePass->draw(maps.level, _receivers[std::size_t(maps.receiver)],
                               _lights[std::size_t(maps.light)].beams);
}

void Engine::slice(LevelMap& map) {
    const CausticsSettings& settings = _scene.caustics;
    Scope scope(_timers, "slicing");
    if (settings.slicing == Slicing::Automatic && _skipping) _smartSlicing.dropEmptyPlanes(map);
    if (settings.slicing == Slicing::Levels)
        _smartSlicing.sliceByLevels(map, settings.depthLevels, settings.threshold);
}

} // namespace limpid
