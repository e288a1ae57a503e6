#include "caustics/FluxSums.h"

#include <algorithm>

namespace limpid {

namespace {
constexpr GLuint binding = 8;
}

double unfocusedFlux(const LevelMap& map, const Light& light) {
    const double area = map.frame.texelArea();
    if (light.type == LightType::Directional) return area;
    const glm::dvec3 away = map.frame.box.center() - light.position;
    return area / std::max(glm::dot(away, away), 1e-12);
}

double fluxPerStep(const LevelMap& map, const Light& light) {
    return unfocusedFlux(map, light) * 0x1p-22;
}

void FluxSums::bind(std::int64_t count) {
    const std::int64_t bytes = 8 * count;
    if (_sums.bytes() < bytes) {
        _sums = {}; // free before more is asked for
        _sums = gl::Buffer(_context.ledger(), "flux sums", bytes);
        _sums.clearToZero();
    }
    _sums.bindStorage(binding);
}

} // namespace limpid
