#include "Anatomy.h"

#include <glm/geometric.hpp>

namespace limpid::models {

Shell body(const std::vector<BodyRow>& rows, const LoftDetail& detail) {
    std::vector<Section> sections;
    for (const BodyRow& row : rows)
        sections.push_back({{row.x, 0.5 * (row.top + row.bottom), 0.0},
                            {0.0, 0.5 * (row.top - row.bottom), 0.0},
                            {0.0, 0.0, -row.halfWidth}});
    return loft(sections, detail);
}

Shell fin(const std::vector<FinRow>& rows) {
    const auto middle = [](const FinRow& row) { return 0.5 * (row.front + row.back); };
    const glm::dvec3 span = middle(rows.back()) - middle(rows.front());
    std::vector<Section> sections;
    for (const FinRow& row : rows) {
        const glm::dvec3 chord = 0.5 * (row.front - row.back);
        const glm::dvec3 across = glm::cross(span, chord);
        const double length = glm::length(across);
        sections.push_back(
            {middle(row), chord, length > 0.0 ? across * (row.halfThickness / length) : glm::dvec3{0.0}});
    }
    return loft(sections, {.ringsPerSpan = 3, .sides = 10});
}

Shell ball(const glm::dvec3& centre, double radius) {
    const auto section = [&](double x, double r) {
        return Section{
            centre + radius * glm::dvec3{x, 0.0, 0.0}, {0.0, radius * r, 0.0}, {0.0, 0.0, -radius * r}};
    };
    return loft({section(1.0, 0.0), section(0.6, 0.8), section(-0.6, 0.8), section(-1.0, 0.0)},
                {.ringsPerSpan = 2, .sides = 8});
}

} // namespace limpid::models
