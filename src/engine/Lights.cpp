#include "engine/Lights.h"

#include <algorithm>

#include "engine/Limits.h"
#include "plan/FlatWater.h"
#include "plan/SunDisc.h"

namespace limpid {

namespace {

using Scope = gl::PassTimers::Scope;

/// Beams do not read where receivers are.
LightFrameData asBeamsRead(LightFrameData frame) {
    frame.sceneDepthRect = LightFrameData().sceneDepthRect;
    return frame;
}

void setStrength(LightWork& work, const glm::dvec3& strength) {
    work.beams.strength = strength;
    if (work.pointLightWater) work.pointLightWater->beams.strength = strength;
    for (DiscPoint& point : work.disc)
        point.beams.strength = strength;
}

/// Of the points of a disc besides its middle, which look at what the middle does: they differ in where their
/// rays come from alone.
std::vector<LightFrameData> discFrames(const Frame& frame, int light) {
    std::vector<LightFrameData> frames;
    if (!sumsBeams(frame.scene.caustics)) return frames;
    const std::vector<Light> points = discPoints(frame.light(light));
    for (std::size_t i = 1; i < points.size(); ++i) {
        LightFrameData& point = frames.emplace_back(frame.planOf(light).frame);
        point.lightDirection = glm::vec4(glm::normalize(points[i].direction), 0);
    }
    return frames;
}

/// A photon stands for an equal piece of the water, whatever quads there are. A grid so fine that the GPU has
/// no room for more is left as it is.
std::optional<WaterPatch> pointLightPatchOf(const Frame& frame, int light) {
    const std::optional<WaterPatch>& patch = frame.planOf(light).pointLightPatch;
    if (!patch || frame.facts().photons || !hasRoomFor(patch->grid, frame.context.info()))
        return std::nullopt;
    return patch;
}

/// Stamps of what stands out of the water.
std::vector<Stamp> dryStamps(const Frame& frame) {
    std::vector<Stamp> stamps;
    for (int i = 0; i < int(frame.plan.receivers.size()); ++i)
        if (frame.plan.receivers[std::size_t(i)].bounds.max.y + frame.plan.origin.y > frame.scene.water.level)
            stamps.push_back(frame.receivers.stamp(i));
    return stamps;
}

bool hasSideMaps(const Plan& plan, int light) {
    return std::any_of(plan.maps.begin(), plan.maps.end(),
                       [&](const PlannedMap& map) { return map.light == light && map.facing > 0; });
}

/// As texelFrame has it.
bool isFlat(const OrientedBox& box) {
    return box.extent.z <= 1e-4 * std::max(box.extent.x, box.extent.y);
}

} // namespace

glm::ivec2 firstHitsSize(const LightFrameData& frame, int mapSize) {
    const glm::vec4& rect = frame.sceneDepthRect;
    // Twice the receivers' own resolution, so that shadow edges are theirs and not this map's.
    const int longer = std::clamp(2 * mapSize, 256, 4096);
    const float most = std::max(rect.z, rect.w);
    return glm::max(glm::ivec2(glm::ceil(glm::vec2(rect.z, rect.w) / most * float(longer))), 1);
}

/// A receiver alone shades itself within its own map, unless a point light sees it from other sides than the
/// box does, or a side map looks from elsewhere.
bool needsFirstHits(const Frame& frame, int light) {
    if (frame.facts().occludesPerBeam || !frame.planOf(light).enters) return false;
    return frame.plan.receivers.size() > 1 || frame.light(light).type == LightType::Point ||
           hasSideMaps(frame.plan, light);
}

/// Beams that go their own ways may meet anything but a plane that is alone; the mean light's shade lacks
/// what lets a part of it through.
bool needsOccluders(const Frame& frame, int light) {
    if (!frame.planOf(light).enters) return false;
    if (!frame.facts().occludesPerBeam) return frame.receivers.translucent();
    return frame.plan.receivers.size() > 1 || hasSideMaps(frame.plan, light) ||
           std::any_of(frame.plan.maps.begin(), frame.plan.maps.end(),
                       [](const PlannedMap& map) { return !isFlat(map.box); });
}

Lights::Lights(gl::Context& context)
    : _tracer(context), _surfaceShadow(context), _firstHits(context), _tiles(context) {}

void Lights::forget() {
    for (LightWork& work : _works)
        work = {};
}

void Lights::refract(const Frame& frame, int light) {
    LightWork& work = _works[std::size_t(light)];
    frameBeams(frame, light, work);
    shadeSurface(frame, light, work);
    const glm::dvec3 strength = strengthOf(frame.light(light), frame.scene.water);
    const bool dark = frame.skipping && strength == glm::dvec3(0);
    const LightWork::TracedFrom from{frame.water.moment(frame.time),
                                     asBeamsRead(frame.planOf(light).frame),
                                     work.shadowed.stamp(),
                                     dark,
                                     pointLightPatchOf(frame, light),
                                     discFrames(frame, light),
                                     frame.skipping && sumsBeams(frame.scene.caustics)};
    work.traced.bring(frame.making, from, [&] {
        if (dark)
            ++frame.skipped.lights;
        else
            trace(frame, light, work, from);
    });
    setStrength(work, strength);
}

void Lights::frameBeams(const Frame& frame, int light, LightWork& work) {
    const LightFrameData& data = frame.planOf(light).frame;
    work.framed.bring(frame.making, {data, frame.plan.patch.grid}, [&] {
        _tracer.prepare(work.beams, frame.water.at(frame.time), frame.light(light), frame.scene.water, data);
    });
}

void Lights::shadeSurface(const Frame& frame, int light, LightWork& work) {
    const LightFrameData& data = frame.planOf(light).frame;
    const bool shaded = data.surfaceShadowRect.z > 0;
    work.shadowed.bring(frame.making, {asBeamsRead(data), shaded ? dryStamps(frame) : std::vector<Stamp>()},
                        [&] {
                            work.surfaceShadow = {};
                            if (!shaded) return;
                            Scope scope(frame.timers, "surface shadow");
                            _surfaceShadow.draw(work.surfaceShadow, work.beams, frame.receivers.all());
                        });
    work.beams.surfaceShadow = shaded ? &work.surfaceShadow : nullptr;
}

void Lights::trace(const Frame& frame, int light, LightWork& work, const LightWork::TracedFrom& from) {
    const WaterMesh& surface = frame.water.at(frame.time);
    Scope scope(frame.timers, "beams");
    _tracer.trace(work.beams, surface, work.beams.surfaceShadow);
    if (!from.pointLightPatch)
        work.pointLightWater.reset();
    else
        tracePointLightWater(frame, light, work, *from.pointLightPatch);
    traceDisc(frame, light, work, from.disc);
    if (!from.tiled) {
        work.tiles = {};
        return;
    }
    _tiles.update(work.tiles, work.mapBeams(), work.mapMesh(surface));
    for (DiscPoint& point : work.disc)
        _tiles.update(point.tiles, point.beams, surface);
}

void Lights::tracePointLightWater(const Frame& frame, int light, LightWork& work, const WaterPatch& patch) {
    if (!work.pointLightWater || work.pointLightWater->patch != patch) {
        work.pointLightWater.reset();
        work.pointLightWater =
            std::make_unique<PointLightWater>(PointLightWater{patch, WaterSurface(frame.context), Beams{}});
    }
    PointLightWater& own = *work.pointLightWater;
    own.surface.update(frame.scene.water, own.patch, frame.plan.origin, frame.time);
    _tracer.prepare(own.beams, own.surface.mesh(), frame.light(light), frame.scene.water,
                    frame.planOf(light).frame);
    _tracer.trace(own.beams, own.surface.mesh(), work.beams.surfaceShadow);
}

void Lights::traceDisc(const Frame& frame, int light, LightWork& work,
                       std::span<const LightFrameData> frames) {
    work.disc.resize(frames.size());
    const WaterMesh& surface = frame.water.mesh();
    for (std::size_t i = 0; i < frames.size(); ++i) {
        Beams& beams = work.disc[i].beams;
        _tracer.prepare(beams, surface, frame.light(light), frame.scene.water, frames[i]);
        _tracer.trace(beams, surface, work.beams.surfaceShadow);
    }
}

void Lights::findFirstHits(const Frame& frame, int light) {
    LightWork& work = _works[std::size_t(light)];
    if (!needsFirstHits(frame, light)) {
        work.sceneDepth = {};
        work.firstHits.forget();
        return;
    }
    const PlannedLight& planned = frame.planOf(light);
    work.firstHits.bring(frame.making,
                         {planned.frame, firstHitsSize(planned.frame, frame.scene.caustics.mapSize),
                          planned.farthest, frame.receivers.stamps()},
                         [&] { drawFirstHits(frame, light, work.sceneDepth); });
}

SceneDepth Lights::firstHits(const Frame& frame, int light) {
    SceneDepth depth;
    drawFirstHits(frame, light, depth);
    return depth;
}

void Lights::drawFirstHits(const Frame& frame, int light, SceneDepth& depth) {
    const PlannedLight& planned = frame.planOf(light);
    Scope scope(frame.timers, "scene depth map");
    _firstHits.draw(depth, firstHitsSize(planned.frame, frame.scene.caustics.mapSize),
                    {work(light).beams, frame.receivers.all(), planned.farthest});
}

void Lights::drawPointLightShadow(const Frame& frame, int light) {
    LightWork& work = _works[std::size_t(light)];
    if (!isSubmerged(frame.light(light), frame.scene.water)) {
        work.beams.pointLightShadow = nullptr;
        return;
    }
    if (!_pointLightShadow) _pointLightShadow = std::make_unique<PointLightShadowPass>(frame.context);
    work.pointLightSurrounds.bring(
        frame.making, {asBeamsRead(frame.planOf(light).frame), frame.receivers.stamps()}, [&] {
            Scope scope(frame.timers, "lamp shadow");
            _pointLightShadow->draw(work.pointLightShadow, work.beams, frame.receivers.all());
        });
    work.beams.pointLightShadow = &work.pointLightShadow;
}

} // namespace limpid
