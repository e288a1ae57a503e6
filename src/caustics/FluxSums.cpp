#include "caustics/FluxSums.h"

#include <algorithm>

#include "core/Tau.h"
#include "gl/Bindings.h"

namespace limpid {

namespace {

/// What all beams of the patch take together, in their unit; of a point light, no more than about that.
double patchFlux(const LevelMap& map, const Light& light, const WaterPatch& patch) {
    const double area = patch.size.x * patch.size.y;
    if (light.type == LightType::Directional)
        return area * std::max(-glm::normalize(light.direction).y, 1e-6);
    const glm::dvec3 away = map.frame.box.center() - light.position;
    return std::min(tau, area / std::max(glm::dot(away, away), 1e-12));
}
} // namespace

double unfocusedFlux(const LevelMap& map, const Light& light) {
    const double area = map.frame.texelArea();
    if (light.type == LightType::Directional) return area;
    const glm::dvec3 away = map.frame.box.center() - light.position;
    return area / std::max(glm::dot(away, away), 1e-12);
}

double fluxPerStep(const LevelMap& map, const Light& light) {
    return unfocusedFlux(map, light) * 0x1p-22;
}

double fluxPerStep(const LevelMap& map, const Light& light, const WaterPatch& patch, double parts) {
    return std::min(fluxPerStep(map, light), patchFlux(map, light, patch) / parts * 0x1p-14);
}

void FluxSums::bind(std::int64_t count) {
    const std::int64_t bytes = 8 * count;
    if (_sums.bytes() < bytes) {
        _sums = {}; // free before more is asked for
        _sums = gl::Buffer(_context.ledger(), "flux sums", bytes);
        _sums.clearToZero();
    }
    _sums.bindStorage(fluxSumsBuffer);
}

} // namespace limpid
