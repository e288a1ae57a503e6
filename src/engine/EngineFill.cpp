#include "engine/Engine.h"
#include "engine/Limits.h"
#include "scene/MethodFacts.h"

/// How each method comes to the light of a map.
namespace limpid {

using Scope = gl::PassTimers::Scope;

/// The middle of a light's disc goes last, so that it is the one whose passed-over beams are counted.
template <typename Pass, typename InputsOf>
void Engine::fillInOnePass(Pass& pass, ReceiverMaps& maps, const InputsOf& inputsOf) {
    const LightState& state = _lights[std::size_t(maps.light)];
    const int points = 1 + int(state.disc.size());
    for (const DiscPoint& point : state.disc)
        pass.deposit(inputsOf(point.beams, cullBeams(maps, point.tiles), points));
    const auto middle = inputsOf(state.mapBeams(), cullBeams(maps, state.tiles), points);
    pass.deposit(middle);
    pass.resolve(maps.caustics, middle);
    if (state.disc.empty()) return;
    const Light& light = _scene.lights[std::size_t(maps.light)];
    _discFilter.apply(maps.caustics, {maps.level, state.beams, light, _scene.water, state.farthest});
}

/// A photon stands for an equal piece of the water, whatever quads there are. A grid so fine that the GPU has
/// no room for more is left as it is.
void Engine::prepareLampWater(int index, const LightFrameData& frame) {
    LightState& state = _lights[std::size_t(index)];
    const Light& light = _scene.lights[std::size_t(index)];
    state.lampWater.reset();
    if (factsOf(_scene.caustics.method).photons) return;
    std::optional<WaterPatch> patch = lampPatch(light, _scene.water, _plan.patch);
    if (!patch || !hasRoomFor(patch->grid, _context.info())) return;
    state.lampWater =
        std::make_unique<LampWater>(LampWater{std::move(*patch), WaterSurface(_context), Beams{}});
    LampWater& own = *state.lampWater;
    own.surface.update(_scene.water, own.patch, _plan.origin, *_causticsTime);
    _beamTracer.prepare(own.beams, own.surface.mesh(), light, _scene.water, frame);
}

void Engine::traceLampWater(LightState& state) {
    if (!state.lampWater) return;
    LampWater& own = *state.lampWater;
    own.surface.update(_scene.water, own.patch, _plan.origin, *_causticsTime);
    _beamTracer.trace(own.beams, own.surface.mesh(), state.beams.surfaceShadow);
}

const WaterMesh& Engine::mapMesh(const LightState& state) const {
    return state.lampWater ? state.lampWater->surface.mesh() : _surface.mesh();
}

/// Of slices, the fill itself finds which surface a texel shows, and only then can sheets before it be asked.
void Engine::fill(ReceiverMaps& maps) {
    fillWhole(maps);
    if (factsOf(_scene.caustics.method).sliceImages) updateTakenLight(maps);
    if (maps.taken.id()) _takenLight->apply(maps.caustics.irradiance, maps.taken);
}

/// All light that comes to the receiver.
void Engine::fillWhole(ReceiverMaps& maps) {
    const LightState& state = _lights[std::size_t(maps.light)];
    const Light& light = _scene.lights[std::size_t(maps.light)];
    Scope scope(_timers, "caustic map");
    if (_skipping && isUnlit(maps) && !factsOf(_scene.caustics.method).sliceImages) {
        maps.caustics.clear(_context, maps.level.frame.size);
        ++_skipped.unlitMaps;
        return;
    }
    countSkipped(maps);
    const Colours colours = _skipping ? Colours::AsNeeded : Colours::All;
    switch (_scene.caustics.method) {
    case Method::LevelMap:
    case Method::LevelMapSmart:
        if (_scene.caustics.fill == Fill::Drawn) {
            _drawnPlanes.fill(maps.caustics, maps.level, state.mapBeams(), mapMesh(state), _scene.water);
            break;
        }
        fillInOnePass(_planeBeams, maps, [&](const Beams& beams, const BeamCulling* culling, int points) {
            return PlaneBeams::Inputs{maps.level,   maps.depths, beams,   mapMesh(state), _plan.patch,
                                      _scene.water, light,       culling, colours,        points};
        });
        break;
    case Method::ExactBeam:
        fillInOnePass(_exactBeams, maps, [&](const Beams& beams, const BeamCulling* culling, int points) {
            return ExactBeams::Inputs{maps.level, maps.receiver,  maps.tangents, occludersOf(maps),
                                      beams,      mapMesh(state), _plan.patch,   _scene.water,
                                      light,      culling,        colours,       points};
        });
        break;
    case Method::Volumetric:
        _volumetric->drawCaustics(maps.slices, maps.level, state.mapBeams(), mapMesh(state), _scene.water);
        _volumetric->combine(maps.caustics, maps.level, maps.slices);
        break;
    case Method::Stencil:
        if (!_stencil) _stencil = std::make_unique<StencilVolumes>(_context);
        _stencil->fill(maps.caustics, maps.level, maps.depths, state.mapBeams(), mapMesh(state),
                       _scene.water);
        break;
    case Method::PhotonSplat:
        splatPhotons(maps);
        break;
    }
}

void Engine::splatPhotons(ReceiverMaps& maps) {
    if (!_photonSplat) _photonSplat = std::make_unique<PhotonSplat>(_context);
    _photonSplat->fill(maps.caustics, {maps.level, maps.receiver, maps.tangents, occludersOf(maps),
                                       _lights[std::size_t(maps.light)].beams, _surface.mesh(), _plan.patch,
                                       _plan.origin, _scene, _scene.lights[std::size_t(maps.light)],
                                       _plan.receivers[std::size_t(maps.receiver)].wet,
                                       _skipping ? Colours::AsNeeded : Colours::All});
}

} // namespace limpid
