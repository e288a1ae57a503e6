#include "plan/SunDisc.h"

#include <cmath>

#include "core/Tau.h"

namespace limpid {

Light beside(const Light& light, const glm::dvec2& offset) {
    const glm::dvec3 middle = glm::normalize(light.direction);
    const glm::dvec3 helper = std::abs(middle.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1);
    const glm::dvec3 right = glm::normalize(glm::cross(helper, middle)), down = glm::cross(middle, right);
    const double radius = std::tan(0.5 * glm::radians(light.angularDiameter));
    Light moved = light;
    moved.direction = middle + radius * (offset.x * right + offset.y * down);
    return moved;
}

std::vector<Light> discPoints(const Light& light) {
    std::vector<Light> points{light};
    if (light.type != LightType::Directional || light.angularDiameter <= 0) return points;
    const double away = std::sqrt(2.0 / 3 * (1 - discPointRadius * discPointRadius));
    for (int i = 0; i < 3; ++i) {
        const double turn = tau * i / 3;
        points.push_back(beside(light, away * glm::dvec2(std::cos(turn), std::sin(turn))));
    }
    return points;
}

} // namespace limpid
