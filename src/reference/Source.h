#pragma once
#include <glm/glm.hpp>

#include "reference/SceneGeometry.h"
#include "reference/Surface.h"
#include "scene/Scene.h"

namespace limpid::reference {

/// Light of one direction, or from one point. A sun's disc is many of them.
struct Source {
    bool point = false;
    glm::dvec3 direction{0, -1, 0};      ///< unit, the way light travels; spot: its axis
    double weight = 1;                   ///< directional: irradiance across `direction` over the light's own
    glm::dvec3 position{0};              ///< point: m from the origin
    glm::dvec3 strength{1};              ///< RGB: W/m² or W/sr
    double cosInner = -2, cosOuter = -3; ///< spot: of its cone's angles; no spot by default

    /// Unit, the way light travels at `place`.
    glm::dvec3 incident(const glm::dvec3& place) const {
        return point ? glm::normalize(place - position) : direction;
    }
    /// Share of a spot's strength that goes along `incident`, [0, 1]; 1 for what is no spot.
    double withinCone(const glm::dvec3& incident) const;
    /// What a triangle takes, m² or sr; its corners counter-clockwise seen from above. Negative from below.
    double through(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) const;
    /// The same for a piece of surface at `place` that is above one m² of the level.
    double density(const glm::dvec3& place, const glm::dvec2& slope) const;
};

/// The light seen from a place of its disc: `disc` in the unit disc, (0, 0) its middle. Uniform places are
/// uniform in flux, as each sends E/(π sin²) of radiance times the cosine to the light's own plane.
Source sourceOf(const Light& light, const glm::dvec3& origin, const glm::dvec2& disc);

/// What keeps light from the water's surface: receivers that stand out of it, and crests before the sun.
class Shade {
  public:
    Shade(const SceneGeometry& geometry, const Surface& surface, double level, const glm::dvec2& patchMin,
          const glm::dvec2& patchMax);

    /// Share of the light that comes to `place`, on the surface and facing the source.
    glm::dvec3 lit(const Source& source, const glm::dvec3& place) const;

  private:
    bool behindCrest(const glm::dvec3& place, const glm::dvec3& up, double distance) const;

    const SceneGeometry& _geometry;
    const Surface& _surface;
    double _level;
    glm::dvec2 _patchMin, _patchMax;
    bool _emergent; ///< whether any receiver rises over the lowest trough
};

} // namespace limpid::reference
