#include "plan/FlatWater.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/Optics.h"
#include "core/Tau.h"
#include "plan/SunDisc.h"
#include "plan/WaveTerms.h"

namespace limpid {

namespace {

glm::dvec3 directionTo(const Light& light, const glm::dvec3& point) {
    return light.type == LightType::Directional ? glm::normalize(light.direction)
                                                : glm::normalize(point - light.position);
}

/// Normals of all slopes up to `steepest`, on two rings and upright.
std::vector<glm::dvec3> possibleNormals(double steepest) {
    std::vector<glm::dvec3> normals{{0, 1, 0}};
    if (steepest <= 0) return normals;
    constexpr int turns = 24;
    for (const double share : {0.5, 1.0})
        for (int i = 0; i < turns; ++i) {
            const double angle = tau * i / turns;
            const double slope = share * steepest;
            normals.push_back(
                glm::normalize(glm::dvec3(-slope * std::cos(angle), 1, -slope * std::sin(angle))));
        }
    return normals;
}

/// Rays flatter than this (sine of the angle to the level) come from slopes that the surface itself would
/// hide.
constexpr double flattest = 0.15;

/// Where rays come from, and whether some are flatter than is looked at and come from further away.
struct Starts : Bounds {
    bool flatter = false;
};

/// Where rays to `point` may start: each possible normal bends the light at the flat crossing.
void addStarts(Starts& starts, const Light& light, const Water& water, const glm::dvec3& point,
               const std::vector<glm::dvec3>& normals) {
    const glm::dvec3 entry = entryPoint(light, water, point);
    const double below = water.level - point.y;
    for (const glm::dvec3& normal : normals) {
        const glm::dvec3 t = refractedAt(light, water, entry, normal);
        const double down = std::max(-t.y, flattest);
        starts.flatter = starts.flatter || -t.y < flattest;
        starts.add({point.x - t.x * below / down, water.level, point.z - t.z * below / down});
    }
}

/// The light and, of a sun's disc, lights all around its rim.
std::vector<Light> partsOf(const Light& light) {
    std::vector<Light> parts{light};
    if (light.type != LightType::Directional || light.angularDiameter <= 0) return parts;
    constexpr int sides = 8;
    // The disc lies within the polygon.
    const double radius = 1 / std::cos(std::numbers::pi / sides);
    for (int i = 0; i < sides; ++i) {
        const double turn = tau * i / sides;
        parts.push_back(beside(light, radius * glm::dvec2(std::cos(turn), std::sin(turn))));
    }
    return parts;
}

/// The points of a box that the outermost rays of a light may go to: its corners, and for a point light
/// beside a long box the places nearest to it, whose rays enter further out.
std::vector<glm::dvec3> outermost(const Bounds& box, const Light& light) {
    const glm::dvec3 nearest = glm::clamp(light.position, box.min, box.max);
    std::vector<glm::dvec3> points;
    for (const double x : {box.min.x, box.max.x, nearest.x})
        for (const double z : {box.min.z, box.max.z, nearest.z})
            for (const double y : {box.min.y, box.max.y})
                points.emplace_back(x, y, z);
    return points;
}

/// From where rays of a light, bent by any slope there may be, reach a box below the level.
void addStarts(Starts& starts, const Light& light, const Water& water, const Bounds& wet,
               const std::vector<glm::dvec3>& normals) {
    for (const Light& part : partsOf(light))
        for (const glm::dvec3& point : outermost(wet, light))
            if (entersWater(part, water)) addStarts(starts, part, water, point, normals);
}

} // namespace

bool entersWater(const Light& light, const Water& water) {
    if (light.type == LightType::Directional) return glm::normalize(light.direction).y < -1e-6;
    // The lowest ray of a cone whose axis is this far from straight down.
    const double fromDown = std::acos(std::clamp(-glm::normalize(light.direction).y, -1.0, 1.0));
    if (light.isSpot() && glm::degrees(fromDown) - light.outerCone >= 90) return false;
    return light.position.y > water.level + 1.001 * highestWave(water);
}

bool isSubmerged(const Light& light, const Water& water) {
    return light.type == LightType::Point && light.position.y < water.level;
}

glm::dvec3 refractedAt(const Light& light, const Water& water, const glm::dvec3& surface,
                       const glm::dvec3& normal) {
    const glm::dvec3 incident = directionTo(light, surface);
    if (glm::dot(incident, normal) >= 0) return incident;
    return optics::refractDirection(incident, normal, 1 / water.ior);
}

glm::dvec3 entryPoint(const Light& light, const Water& water, const glm::dvec3& point) {
    const double below = std::max(water.level - point.y, 0.0);
    if (light.type == LightType::Directional) {
        const glm::dvec3 t = refractedAt(light, water, point);
        return point - t * (below / -t.y);
    }
    const glm::dvec2 foot(light.position.x, light.position.z);
    const glm::dvec2 away = glm::dvec2(point.x, point.z) - foot;
    const double across = glm::length(away);
    const double x = optics::flatCrossing(light.position.y - water.level, below, across, water.ior);
    const glm::dvec2 at = across > 0 ? foot + away * (x / across) : foot;
    return {at.x, water.level, at.y};
}

glm::dvec3 meanDirection(const Light& light, const Water& water, const glm::dvec3& point) {
    if (!entersWater(light, water)) return {0, -1, 0};
    return refractedAt(light, water, entryPoint(light, water, point));
}

WaterPatch coveringPatch(const Scene& scene) {
    const Water& water = scene.water;
    Bounds wet = worldBounds(scene);
    Starts starts;
    wet.max.y = std::min(wet.max.y, water.level);
    if (!wet.empty() && wet.min.y < water.level) {
        const auto normals = possibleNormals(steepestSlope(water));
        for (const Light& light : scene.lights)
            addStarts(starts, light, water, wet, normals);
        starts.add({wet.min.x, water.level, wet.min.z}), starts.add({wet.max.x, water.level, wet.max.z});
    } else {
        starts.add({-1, 0, -1}), starts.add({1, 0, 1});
    }
    WaterPatch patch;
    patch.grid = water.grid;
    // Crests lift the start of a ray off the mean level, and one quad more lets every inner texel see whole
    // beams.
    const double lift = 2 * highestWave(water);
    const glm::dvec2 middle(starts.center().x, starts.center().z);
    patch.center = water.center.value_or(middle);
    const glm::dvec2 aside = 2.0 * glm::abs(patch.center - middle);
    const glm::dvec2 size = aside + glm::max(glm::dvec2(starts.size().x, starts.size().z) + lift, 1e-6);
    patch.size =
        water.size.value_or(size * (1.0 + 2.0 / glm::dvec2(water.grid)) + 1e-3 * std::max(size.x, size.y));
    return patch;
}

glm::vec4 rectOf(const WaterPatch& patch, const glm::dvec3& origin) {
    return glm::vec4(patch.min() - glm::dvec2(origin.x, origin.z), patch.size);
}

namespace {

/// Where light on its way to a box below the level starts; empty if none does.
Starts startsOf(const Water& water, const Light& light, const Bounds& wet) {
    Starts starts;
    if (!wet.empty()) addStarts(starts, light, water, wet, possibleNormals(steepestSlope(water)));
    if (starts.empty()) return starts;
    const double lift = 2 * highestWave(water);
    starts.min -= glm::dvec3(lift, 0, lift), starts.max += glm::dvec3(lift, 0, lift);
    return starts;
}

} // namespace

WaterPatch lightingPatch(const Water& water, const Light& light, const Bounds& wet, const WaterPatch& patch) {
    const Starts starts = startsOf(water, light, wet);
    if (starts.empty()) return patch;
    const glm::dvec2 low = glm::max(glm::dvec2(starts.min.x, starts.min.z), patch.min());
    const glm::dvec2 high = glm::min(glm::dvec2(starts.max.x, starts.max.z), patch.min() + patch.size);
    if (high.x <= low.x || high.y <= low.y) return patch;
    return {0.5 * (low + high), high - low, patch.grid, {}};
}

Bounds entriesTo(const Water& water, const Light& light, const Bounds& wet) {
    const Starts starts = startsOf(water, light, wet);
    if (starts.empty()) return starts;
    // Slopes are looked at in 24 directions, which leaves out a hundredth between them.
    glm::dvec3 margin = (starts.flatter ? 1.0 : 0.05) * starts.size();
    margin.y = highestWave(water);
    return {starts.min - margin, starts.max + margin};
}

bool mayReach(const Water& water, const Light& light, const Bounds& wet, const WaterPatch& patch) {
    const Starts starts = startsOf(water, light, wet);
    if (starts.empty()) return false;
    // Rays that are flatter than startsOf looks at come from further away.
    const glm::dvec2 low(starts.min.x, starts.min.z), high(starts.max.x, starts.max.z);
    const glm::dvec2 margin = high - low;
    return glm::all(glm::lessThan(low - margin, patch.min() + patch.size)) &&
           glm::all(glm::greaterThan(high + margin, patch.min()));
}

} // namespace limpid
