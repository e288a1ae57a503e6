#pragma once
#include <optional>

#include "apps/viewer/Projection.h"
#include "scene/Scene.h"

namespace limpid::viewer {

struct Hit {
    int receiver = 0;
    glm::dvec3 point{0}; ///< world, m
};

/// What a straight ray meets first within `farthest` m.
std::optional<Hit> firstAlong(const Scene& scene, const Ray& ray, double farthest);

/// What a view ray meets first, refracted where it crosses flat water (or mirrored, beyond Snell's window).
std::optional<Hit> pick(const Scene& scene, const Ray& ray);

} // namespace limpid::viewer
