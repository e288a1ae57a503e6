#include "engine/Maps.h"

#include <algorithm>
#include <cassert>

#include "caustics/Methods.h"
#include "core/OneOf.h"
#include "levelmap/Coverage.h"
#include "occlusion/TakenLight.h"
#include "plan/Shading.h"

namespace limpid {

namespace {

using Scope = gl::PassTimers::Scope;

/// Texels on the longer side, and planes.
glm::ivec2 fittedSize(const Frame& frame, const MapWork& map) {
    const int size = mapSize(frame.scene, frame.plan.patch, map.plan.box, map.plan.facing);
    const int planes = frame.scene.caustics.planes;
    return {std::max(size >> map.halvings, std::min(size, 16)),
            std::max(planes >> map.halvings, std::min(planes, 3))};
}

/// What may be in the way of a map's light, by when it was made; nothing where nothing is asked. Shares of
/// what sheets let through are multiplied in the order in which all things are sorted.
std::vector<Stamp> shadedBy(const Frame& frame, const MapWork& map) {
    if (!needsOccluders(frame, map.plan.light)) return {};
    if (frame.receivers.translucent()) return frame.receivers.stamps();
    return frame.receivers.stampsOf(map.shadedBy);
}

/// Alone and seen along the light, a receiver has nothing before it but itself.
bool isAlone(const Frame& frame, const MapWork& map) {
    return map.plan.facing == 0 && frame.plan.receivers.size() == 1 &&
           frame.light(map.plan.light).type == LightType::Directional;
}

bool isShaded(const Frame& frame, const MapWork& map) {
    return needsFirstHits(frame, map.plan.light) && !isAlone(frame, map);
}

MapWork::LevelFrom levelFrom(const Frame& frame, const MapWork& map) {
    const CausticsSettings& settings = frame.scene.caustics;
    const PlannedLight& light = frame.planOf(map.plan.light);
    const glm::ivec2 size = fittedSize(frame, map);
    MapWork::LevelFrom from{map.plan,
                            size.x,
                            size.y,
                            frame.plan.origin,
                            settings.method,
                            frame.receivers.stamp(map.plan.receiver),
                            light.frame,
                            {},
                            {}};
    from.frame.sceneDepthRect = from.frame.surfaceShadowRect = glm::vec4(0);
    if (isShaded(frame, map))
        from.shade =
            MapWork::ShadeFrom{light.frame.sceneDepthRect, firstHitsSize(light.frame, settings.mapSize),
                               light.farthest, frame.receivers.stampsOf(map.shadedBy)};
    if (frame.facts().slicing)
        from.slicing =
            MapWork::SlicingFrom{settings.slicing, settings.depthLevels, settings.threshold, frame.skipping};
    return from;
}

MapWork::PreparedFrom preparedFrom(const Frame& frame, const MapInputs& inputs, const MapWork& map) {
    return {map.drawn.stamp(), inputs.settings().fill, inputs.unlit, inputs.skipping, shadedBy(frame, map)};
}

MapWork::FilledFrom filledFrom(const Frame& frame, const MapInputs& inputs, const MapWork& map) {
    MapWork::FilledFrom from{map.prepared.stamp(),
                             inputs.work.traced.stamp(),
                             inputs.light,
                             frame.scene.water.absorption,
                             frame.scene.water.scattering,
                             inputs.settings(),
                             {},
                             inputs.unlit,
                             inputs.skipping,
                             shadedBy(frame, map)};
    from.light.name.clear();
    // Which maps there are and of what time is another's choice.
    from.settings.texelsPerPixel = from.settings.refresh = 0;
    if (!inputs.work.disc.empty()) from.farthest = frame.planOf(map.plan.light).farthest;
    return from;
}

void layOut(const Frame& frame, MapWork& map) {
    const glm::ivec2 size = fittedSize(frame, map);
    prepareLevelMap(frame.context, map.level,
                    {map.plan.box, *map.plan.facings, map.plan.gradients, size.x, size.y, frame.plan.origin});
}

/// What filling a map leaves out by its settings.
void countSkipped(const Frame& frame, const MapWork& map) {
    if (!frame.skipping) return;
    const CausticsSettings& settings = frame.scene.caustics;
    const int all = map.level.frame.flat ? 1 : map.level.requestedPlanes;
    if (frame.facts().slicing && settings.slicing == Slicing::Automatic)
        frame.skipped.planes += all - int(map.level.planes.size());
    if (fillOf(settings.method, settings.fill) == Fill::OnePass)
        frame.skipped.channels += 3 - channelsOf(Colours::AsNeeded, frame.scene.water);
}

} // namespace

bool isUnlit(const MapWork& map, const LightWork& light) {
    return light.isDark() || !map.plan.inReach;
}

struct Maps::Passes {
    explicit Passes(gl::Context& context) : levelMaps(context) {}

    LevelMapPass levelMaps;
    OneOf<CausticMethods> methods;
    std::unique_ptr<CoveragePass> coverage; ///< made when light is counted
    std::unique_ptr<TakenLight> takenLight; ///< made for the first translucent receiver
};

Maps::Maps(gl::Context& context) : _passes(std::make_unique<Passes>(context)) {}

Maps::~Maps() = default;

void Maps::plan(const Scene& scene, const Plan& plan) {
    std::vector<MapWork> before = std::move(_maps);
    _maps.clear();
    for (const PlannedMap& planned : plan.maps) {
        const auto same = std::find_if(before.begin(), before.end(), [&](const MapWork& map) {
            return map.plan.receiver == planned.receiver && map.plan.light == planned.light &&
                   map.plan.facing == planned.facing;
        });
        MapWork& map = same == before.end() ? _maps.emplace_back() : _maps.emplace_back(std::move(*same));
        map.plan = planned;
        map.level.facing = planned.facing;
        map.shadedBy = mayShade(scene, plan, planned);
    }
}

void Maps::forget() {
    for (MapWork& map : _maps) {
        MapWork empty;
        empty.plan = std::move(map.plan);
        empty.shadedBy = std::move(map.shadedBy);
        empty.halvings = map.halvings;
        empty.level.facing = empty.plan.facing;
        map = std::move(empty);
    }
    _passes->methods.forEach([](auto& method) { method.free(); });
}

MapInputs Maps::inputsOf(const Frame& frame, const Lights& lights, const MapWork& map) {
    const int light = map.plan.light;
    const LightWork& work = lights.work(light);
    return {frame.timers,
            frame.skipped,
            _passes->levelMaps,
            frame.scene,
            frame.plan,
            frame.light(light),
            work,
            {frame.receivers.at(map.plan.receiver), map.plan.receiver, work.beams,
             isShaded(frame, map) ? &work.sceneDepth.first : nullptr},
            needsOccluders(frame, light) ? &frame.receivers.occluders(frame.timers) : nullptr,
            frame.skipping && isUnlit(map, work),
            frame.skipping};
}

bool Maps::draw(const Frame& frame, const Lights& lights, MapWork& map) {
    CausticMethods& chosen = _passes->methods.get(frame.scene.caustics.method, frame.context);
    const MapInputs inputs = inputsOf(frame, lights, map);
    const bool drawn = map.drawn.bring(frame.making, levelFrom(frame, map), [&] {
        layOut(frame, map);
        std::visit([&](auto& method) { method.draw(map, inputs); }, chosen);
    });
    const bool prepared = map.prepared.bring(frame.making, preparedFrom(frame, inputs, map), [&] {
        std::visit([&](auto& method) { method.prepare(map, inputs); }, chosen);
        map.taken = {};
        if (!frame.facts().sliceImages) takeLight(frame, inputs, map);
    });
    return drawn || prepared;
}

/// Beams that go their own way are asked about sheets one by one; the mean light here.
void Maps::takeLight(const Frame& frame, const MapInputs& inputs, MapWork& map) {
    const bool shaded = inputs.occluders && !frame.facts().occludesPerBeam && frame.receivers.translucent();
    if (!inputs.receiver.geometry.translucent() && !shaded) return;
    if (!_passes->takenLight) _passes->takenLight = std::make_unique<TakenLight>(frame.context);
    Scope scope(frame.timers, "taken light");
    map.taken = _passes->takenLight->opacity(map.level, inputs.receiver);
    if (shaded) _passes->takenLight->shade(map.taken, map.level, inputs.receiver, *inputs.occluders);
}

bool Maps::fill(const Frame& frame, const Lights& lights, MapWork& map) {
    assert(map.isDrawn());
    const MapInputs inputs = inputsOf(frame, lights, map);
    return map.filled.bring(frame.making, filledFrom(frame, inputs, map), [&] {
        fillAll(frame, inputs, map);
        // Of slices, the fill itself finds which surface a texel shows, and only then can sheets before it be
        // asked.
        if (frame.facts().sliceImages) takeLight(frame, inputs, map);
        if (map.taken.id()) _passes->takenLight->apply(map.caustics.irradiance, map.taken);
    });
}

/// All light that comes to the receiver.
void Maps::fillAll(const Frame& frame, const MapInputs& inputs, MapWork& map) {
    const WaterMesh& water = frame.water.at(frame.time);
    Scope scope(frame.timers, "caustic map");
    if (inputs.unlit && !frame.facts().sliceImages) {
        map.caustics.clear(frame.context, map.level.frame.size);
        ++frame.skipped.unlitMaps;
        return;
    }
    countSkipped(frame, map);
    std::visit([&](auto& method) { method.fill(map, inputs, water); },
               _passes->methods.get(frame.scene.caustics.method, frame.context));
}

gl::Texture Maps::coverage(const Frame& frame, const Lights& lights, const MapWork& map) {
    Scope scope(frame.timers, "coverage");
    if (!_passes->coverage) _passes->coverage = std::make_unique<CoveragePass>(frame.context);
    return _passes->coverage->draw(map.level, frame.receivers.at(map.plan.receiver),
                                   lights.work(map.plan.light).beams);
}

} // namespace limpid
