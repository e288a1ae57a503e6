#include "engine/Engine.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/Error.h"
#include "engine/Limits.h"
#include "gl/Guard.h"
#include "plan/Framing.h"

namespace limpid {

namespace {

/// The scene without what a plan does not depend on.
Scene asPlanned(Scene scene) {
    const Scene plain;
    scene.camera = plain.camera;
    scene.skyRadiance = plain.skyRadiance;
    scene.ambientRadiance = plain.ambientRadiance;
    scene.caustics = plain.caustics;
    scene.godrays = plain.godrays;
    scene.water.absorption = plain.water.absorption;
    scene.water.scattering = plain.water.scattering;
    scene.water.anisotropy = plain.water.anisotropy;
    for (Light& light : scene.lights) {
        light.name.clear();
        light.irradiance = light.intensity = glm::dvec3(1);
    }
    for (Receiver& receiver : scene.receivers)
        receiver.name.clear();
    return scene;
}

/// The time that the caustics of a picture at `time` are of.
double causticsTimeOf(const CausticsSettings& settings, double time) {
    return settings.refresh > 0 ? std::floor(time * settings.refresh + 1e-9) / settings.refresh : time;
}

/// Whether maps of both scenes have room in each other's place, so that nothing need be freed before the
/// first is made.
bool sameSizes(const Scene& a, const Scene& b) {
    return a.caustics.method == b.caustics.method && a.caustics.fill == b.caustics.fill &&
           a.caustics.mapSize == b.caustics.mapSize && a.caustics.planes == b.caustics.planes &&
           a.water.grid == b.water.grid && a.lights.size() == b.lights.size() &&
           a.receivers.size() == b.receivers.size();
}

} // namespace

Engine::Engine(gl::Context& context)
    : _context(context), _receivers(context), _water(context, _timers, _making), _lights(context),
      _maps(context), _pictures(context) {}

void Engine::requireScene(const Scene& scene, const gl::Context& context) {
    requireGrid(scene.water.grid, context.info());
    requirePlanes(scene.caustics, context.info());
}

void Engine::forgetAll() {
    _lights.forget();
    _maps.forget();
    _water.forget();
    _pictures.forget();
}

/// All that a public call draws: in a state of its own, and with nothing half-made where it fails. Then
/// nothing is kept: what is left on the GPU may be what there was no room for. If that were the targets of
/// the picture before, there is another try without them.
template <typename Work>
auto Engine::whole(Work&& work) {
    const gl::Guard guard(_context);
    const bool holdsTargets = _pictures.holdsTargets();
    try {
        return work();
    } catch (const GraphicsError&) {
        forgetAll();
        if (!holdsTargets) throw;
    } catch (...) {
        forgetAll();
        throw;
    }
    return whole(work);
}

void Engine::set(Scene scene) {
    if (_asked && scene == *_asked) return;
    requireScene(scene, _context);
    const gl::Guard guard(_context);
    if (!_asked || asPlanned(scene) != asPlanned(*_asked)) {
        Plan plan = planOf(scene, _plan.receivers);
        _receivers.set(scene.receivers, plan.origin);
        _plan = std::move(plan);
        _water.set(scene.water, _plan.patch, _plan.origin);
        _lights.resize(scene.lights.size());
        _maps.plan(scene, _plan);
    }
    if (!_asked || !sameSizes(scene, *_asked)) {
        _lights.forget();
        _maps.forget();
        _pictures.forget();
    }
    if (scene.caustics.texelsPerPixel <= 0) _maps.makeWhole();
    _asked = scene;
    _scene = std::move(scene);
    _scene.camera = framedCamera(_scene);
}

Frame Engine::frame() {
    return {_context, _timers,    _making, _skipped,      _scene,
            _plan,    _receivers, _water,  _causticsTime, _skipping};
}

/// An update to `time`, with caustics of another.
void Engine::start(double causticsTime, double time) {
    assert(std::isfinite(time));
    _causticsTime = causticsTime;
    _time = time;
    _skipped = {};
    _water.readHosts();
    for (MapWork& map : _maps.all())
        map.culled = false;
    if (!_reuse) _making.startAnew();
}

void Engine::makeLights(const Frame& frame) {
    bool occluded = false;
    for (int light = 0; light < _lights.count(); ++light) {
        _lights.refract(frame, light);
        _lights.findFirstHits(frame, light);
        occluded = occluded || needsOccluders(frame, light);
    }
    if (!occluded) _receivers.freeOccluders();
}

void Engine::makeMap(const Frame& frame, MapWork& map) {
    if (!_maps.draw(frame, _lights, map)) ++_skipped.levelMaps;
    if (!_maps.fill(frame, _lights, map)) ++_skipped.causticMaps;
}

void Engine::makeAll(const Frame& frame) {
    makeLights(frame);
    for (MapWork& map : _maps.all())
        makeMap(frame, map);
    _water.at(_time);
}

void Engine::updateCaustics(double time) {
    whole([&] {
        start(time, time);
        _maps.makeWhole();
        makeAll(frame());
    });
}

void Engine::updateForPictures(double time) {
    whole([&] {
        start(causticsTimeOf(_scene.caustics, time), time);
        makeAll(frame());
    });
}

Skipped Engine::skipped() const {
    Skipped skipped = _skipped;
    for (const MapWork& map : _maps.all()) {
        if (!map.culled) continue;
        const auto asked = map.askedBeams.read<std::uint32_t>(1).front();
        skipped.beams += light(map.plan.light).mapBeams().triangleCount - std::int64_t(asked);
        if (asked == 0) ++skipped.unlitMaps;
    }
    return skipped;
}

std::int64_t Engine::beamsDrawn(int index) const {
    const LightWork& work = light(index);
    if (_skipping && work.isDark()) return 0;
    return work.tiles.quads == glm::ivec2(0) ? work.mapBeams().triangleCount : work.tiles.reachedBeams();
}

gl::Texture Engine::coverage(const MapWork& map) {
    return whole([&] { return _maps.coverage(frame(), _lights, map); });
}

/// The maps that a picture of `size` shows, of as many texels as it asks for. Returns which.
std::vector<bool> Engine::makeShown(const Frame& frame, glm::ivec2 size) {
    for (MapWork& map : _maps.all())
        map.halvings = halvingsFor(frame, map, size);
    std::vector<bool> shown = shownMaps(frame, _lights, _maps, _pictures.heightAtCamera(frame, _time), size);
    for (std::size_t i = 0; i < shown.size(); ++i)
        if (shown[i]) makeMap(frame, _maps.all()[i]);
    return shown;
}

/// Calls `use` with the frame and what a picture of `size` is drawn of; `goesOn`: one that was begun before.
template <typename Use>
auto Engine::picture(glm::ivec2 size, bool goesOn, Use&& use) {
    return whole([&] {
        const Skipped before = _skipped;
        const Frame now = frame();
        makeLights(now);
        const std::vector<bool> shown = makeShown(now, size);
        // What was left out is counted by updates.
        _skipped.levelMaps = before.levelMaps, _skipped.causticMaps = before.causticMaps;
        for (int light = 0; light < _lights.count(); ++light)
            _lights.drawPointLightShadow(now, light);
        const double waterHeight = _pictures.heightAtCamera(now, _time);
        const WaterMesh& surface = _water.at(_time);
        if (!goesOn) {
            // That make maps ready to be projected.
            _skipped.unreadPasses += std::count(shown.begin(), shown.end(), false);
            _pictures.drawGodrays(now, _lights, surface, waterHeight, size);
        }
        return use(now, Pictures::Subject{_lights, _maps, shown, surface, waterHeight});
    });
}

/// What a picture at `time` shows.
void Engine::makeFor(double time, glm::ivec2 size) {
    start(causticsTimeOf(_scene.caustics, time), time);
    const Frame now = frame();
    makeLights(now);
    const std::vector<bool> shown = makeShown(now, size);
    for (std::size_t i = 0; i < shown.size(); ++i)
        if (const MapWork& map = _maps.all()[i]; !shown[i])
            ++(isUnlit(map, light(map.plan.light)) ? _skipped.unlitMaps : _skipped.outOfView);
}

Picture Engine::render(double time, glm::ivec2 size) {
    return whole([&] {
        makeFor(time, size);
        return draw(size);
    });
}

std::vector<std::uint8_t> Engine::renderToneMapped(double time, glm::ivec2 size) {
    return whole([&] {
        makeFor(time, size);
        return picture(size, false, [&](const Frame& frame, const Pictures::Subject& subject) {
            return _pictures.drawToneMapped(frame, subject, size);
        });
    });
}

Picture Engine::draw(glm::ivec2 size) {
    return picture(size, false, [&](const Frame& frame, const Pictures::Subject& subject) {
        return _pictures.draw(frame, subject, size);
    });
}

PicturePass::Sketch Engine::beginPicture(glm::ivec2 size, int perPixel, PicturePass::Sketch used) {
    return picture(size, false, [&](const Frame& frame, const Pictures::Subject& subject) {
        return _pictures.begin(frame, subject, size, perPixel, std::move(used));
    });
}

void Engine::drawRows(const PicturePass::Sketch& sketch, glm::ivec2 rows) {
    picture(sketch.samples().size() / sketch.perPixel(), true,
            [&](const Frame& frame, const Pictures::Subject& subject) {
                _pictures.drawRows(frame, subject, sketch, rows);
            });
}

} // namespace limpid
