#pragma once
#include <array>
#include <cmath>

#include <glm/glm.hpp>

#include "plan/Facings.h"

namespace limpid::reference {

/// Which of a receiver's maps holds a face, as the bake sorts them: faces that run along the mean light go to
/// a side map by where they look.
struct FaceSorting {
    glm::dvec3 light{0, -1, 0};       ///< mean light, unit
    double steep = 0;                 ///< |normal · light| below which a face runs along the light
    std::array<glm::dvec3, 4> axes{}; ///< unit, across the light
    std::array<bool, 4> used{};       ///< whether axis k has a map
    bool sheet = false;               ///< both sides of a face take light, each in its own map

    /// 0 the map along the light; k the side map of axis k - 1. `normal`: unit, by the winding.
    int mapOf(const glm::dvec3& normal) const {
        if (std::abs(glm::dot(normal, light)) >= steep) return 0;
        std::size_t best = 0;
        for (std::size_t k = 1; k < 4; ++k)
            if (glm::dot(normal, axes[k]) > glm::dot(normal, axes[best])) best = k;
        return used[best] ? int(best) + 1 : 0;
    }
    /// Whether map `facing` shows the face.
    bool shows(int facing, const glm::dvec3& normal) const {
        return mapOf(normal) == facing || (sheet && mapOf(-normal) == facing);
    }
};

/// The bake's sorting of faces over maps, as ray tracers read it.
inline FaceSorting sortingOf(const Facings& facings) {
    return {facings.light, Facings::steep, facings.axes, facings.used, facings.sheet};
}

} // namespace limpid::reference
