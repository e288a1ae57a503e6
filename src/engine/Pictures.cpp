#include "engine/Pictures.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/OneOf.h"
#include "godrays/GodrayMethods.h"
#include "plan/MapPlan.h"
#include "view/Visibility.h"

namespace limpid {

namespace {

ViewFrameData viewOf(const Frame& frame, double waterHeight, glm::ivec2 size) {
    return viewFrame(frame.scene, frame.plan.origin, frame.plan.patch, frame.plan.sides, waterHeight, size);
}

} // namespace

struct Pictures::Passes {
    std::optional<PicturePass> picture;
    std::optional<GodrayTarget> target;
    OneOf<GodrayMethods> methods;
};

Pictures::Pictures(gl::Context& context) : _context(context), _passes(std::make_unique<Passes>()) {}

Pictures::~Pictures() = default;

bool Pictures::holdsTargets() const {
    return _passes->picture && _passes->picture->holdsTargets();
}

void Pictures::forget() {
    if (_passes->picture) _passes->picture->forget();
}

std::vector<bool> shownMaps(const Frame& frame, const Lights& lights, const Maps& maps, double waterHeight,
                            glm::ivec2 size) {
    const ViewFrameData view = viewOf(frame, waterHeight, size);
    std::vector<bool> shown;
    for (const MapWork& map : maps.all())
        shown.push_back(!frame.skipping ||
                        (!isUnlit(map, lights.work(map.plan.light)) &&
                         mayShowCaustics(view, frame.plan.receivers[std::size_t(map.plan.receiver)].bounds)));
    return shown;
}

int halvingsFor(const Frame& frame, const MapWork& map, glm::ivec2 size) {
    const Scene& scene = frame.scene;
    const double perPixel = scene.caustics.texelsPerPixel;
    if (perPixel <= 0) return 0;
    const double pixelsPerTangent = size.y / (2 * std::tan(0.5 * glm::radians(scene.camera.verticalFov)));
    const Bounds& bounds = frame.plan.receivers[std::size_t(map.plan.receiver)].bounds;
    const double radius = 0.5 * glm::length(bounds.size());
    const double away = glm::distance(*scene.camera.position - frame.plan.origin, bounds.center()) - radius;
    // Water between brings things nearer by its index, at most.
    const double pixels = away > 0 ? pixelsPerTangent * 2 * radius / away * scene.water.ior : 1e9;
    const double spare =
        mapSize(scene, frame.plan.patch, map.plan.box, map.plan.facing) / (perPixel * pixels);
    return std::clamp(int(std::floor(std::log2(std::max(spare, 1e-9)))), 0, 16);
}

double Pictures::heightAtCamera(const Frame& frame, double time) {
    const StandsIn from{frame.water.moment(time), *frame.scene.camera.position};
    _stands.bring(frame.making, from, [&] {
        _waterHeight =
            limpid::heightAtCamera(frame.scene, frame.plan.origin, frame.plan.patch, frame.water.at(time));
    });
    return _waterHeight;
}

/// None where nothing is scattered, or the camera is above.
void Pictures::drawGodrays(const Frame& frame, Lights& lights, const WaterMesh& surface, double waterHeight,
                           glm::ivec2 size) {
    _godrays = nullptr;
    const GodrayMethod wanted = frame.scene.godrays.method;
    if (wanted == GodrayMethod::None || frame.scene.water.scattering == glm::dvec3(0)) return;
    const ViewFrameData view = viewOf(frame, waterHeight, size);
    if (view.cameraAbove()) return;
    std::vector<SceneDepth> own; // of lights whose maps do without one, and are to go on so
    own.reserve(std::size_t(lights.count()));
    std::vector<GodraySource> sources;
    for (int light = 0; light < lights.count(); ++light) {
        const LightWork& work = lights.work(light);
        if (work.isDark()) continue;
        const bool there = work.sceneDepth.first.id() != 0;
        if (!there) own.push_back(lights.firstHits(frame, light));
        sources.push_back({work.beams, there ? work.sceneDepth : own.back(), frame.light(light),
                           frame.planOf(light).farthest});
    }
    if (sources.empty()) return;
    if (!_passes->target) _passes->target.emplace(_context);
    gl::PassTimers::Scope scope(frame.timers, "godrays");
    const GodrayCamera camera{view.viewProjection, glm::vec3(view.cameraPosition), size};
    const GodrayInputs inputs{
        frame.scene, surface, frame.plan.patch, frame.plan.origin, frame.receivers.all(), sources, camera};
    std::visit([&](auto& method) { method.draw(*_passes->target, inputs); },
               _passes->methods.get(wanted, _context));
    _godrays = &_passes->target->radiance();
}

/// Calls `use` with the picture pass and its inputs.
template <typename Use>
auto Pictures::withInputs(const Frame& frame, const Subject& subject, Use&& use) {
    std::vector<Lit> lit;
    for (std::size_t i = 0; i < subject.shown.size(); ++i) {
        const MapWork& map = subject.maps.all()[i];
        if (subject.shown[i])
            lit.push_back({map.plan.receiver, &map.level, &map.caustics, map.filled.stamp()});
    }
    std::vector<const Beams*> beams;
    for (int light = 0; light < subject.lights.count(); ++light)
        beams.push_back(&subject.lights.work(light).beams);
    if (!_passes->picture) _passes->picture.emplace(_context);
    gl::PassTimers::Scope scope(frame.timers, "picture");
    return use(*_passes->picture, PicturePass::Inputs{frame.scene, frame.plan.origin, frame.plan.patch,
                                                      subject.surface, frame.plan.sides, subject.waterHeight,
                                                      frame.receivers.all(), lit, beams, _godrays});
}

Picture Pictures::draw(const Frame& frame, const Subject& subject, glm::ivec2 size) {
    return withInputs(frame, subject,
                      [&](PicturePass& pass, const auto& inputs) { return pass.draw(inputs, size); });
}

std::vector<std::uint8_t> Pictures::drawToneMapped(const Frame& frame, const Subject& subject,
                                                   glm::ivec2 size) {
    return withInputs(frame, subject, [&](PicturePass& pass, const auto& inputs) {
        return pass.drawToneMapped(inputs, size);
    });
}

PicturePass::Sketch Pictures::begin(const Frame& frame, const Subject& subject, glm::ivec2 size, int perPixel,
                                    PicturePass::Sketch used) {
    return withInputs(frame, subject, [&](PicturePass& pass, const auto& inputs) {
        return pass.begin(inputs, size, perPixel, std::move(used));
    });
}

void Pictures::drawRows(const Frame& frame, const Subject& subject, const PicturePass::Sketch& sketch,
                        glm::ivec2 rows) {
    withInputs(frame, subject,
               [&](PicturePass& pass, const auto& inputs) { pass.drawRows(inputs, sketch, rows); });
}

} // namespace limpid
