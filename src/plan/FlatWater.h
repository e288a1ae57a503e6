#pragma once
#include <array>
#include <vector>

#include <glm/glm.hpp>

#include "scene/Scene.h"

/// How light would go if the water were flat: the mean light that boxes, occlusion and the patch's extent are
/// made from. All positions relative to the same origin, m.
namespace limpid {

/// True for a light that enters the water from above: a sun over the horizon, a point light over the highest
/// crest whose cone, if it has one, reaches below the horizon.
bool entersWater(const Light& light, const Water& water);

/// True for a point light below the level: it lights directly and makes no caustic.
bool isSubmerged(const Light& light, const Water& water);

/// Where the light that reaches `point` (below the level) under flat water crosses the surface.
/// `light` must enter the water.
glm::dvec3 entryPoint(const Light& light, const Water& water, const glm::dvec3& point);

/// Unit direction below a surface with unit normal `normal` of the light that meets it at `surface`.
glm::dvec3 refractedAt(const Light& light, const Water& water, const glm::dvec3& surface,
                       const glm::dvec3& normal = {0, 1, 0});

/// Unit direction of the light at `point` under flat water; straight down for a light that does not enter.
glm::dvec3 meanDirection(const Light& light, const Water& water, const glm::dvec3& point);

/// The rectangle of the surface that beams must start from.
struct WaterPatch {
    glm::dvec2 center{0}; ///< x, z
    glm::dvec2 size{2};   ///< m
    glm::ivec2 grid{1};   ///< quads; equally wide, unless there are
    /// Lines between quads, m from min() along x and z, both ends included: as many as `grid` says and one
    /// more, or none.
    std::array<std::vector<double>, 2> lines{};

    glm::dvec2 min() const { return center - 0.5 * size; }
    bool operator==(const WaterPatch&) const = default;
};

/// A patch as shaders have it: x, z of its corner and extents, m, single precision relative to `origin`.
glm::vec4 rectOf(const WaterPatch& patch, const glm::dvec3& origin);

/// What the scene asks for, or else every place from which a ray of any light, refracted by any slope that
/// the waves can have, may reach a receiver (the receivers' bounding box below the level). Positions in the
/// world.
WaterPatch coveringPatch(const Scene& scene);

/// False where no light that goes through `patch` can come to a box below the level (in the world).
bool mayReach(const Water& water, const Light& light, const Bounds& wet, const WaterPatch& patch);

/// A box around every place of the surface, waves included, where light enters that may come to a box below
/// the level (in the world); empty where none can.
Bounds entriesTo(const Water& water, const Light& light, const Bounds& wet);

/// The part of `patch` from which one light may reach a box below the level (in the world): all of it where
/// the light reaches none.
WaterPatch lightingPatch(const Water& water, const Light& light, const Bounds& wet, const WaterPatch& patch);

} // namespace limpid
