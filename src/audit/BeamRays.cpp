#include "audit/BeamRays.h"

#include <algorithm>
#include <array>
#include <utility>

namespace limpid {

glm::dvec3 trianglePlace(double place) {
    constexpr int digits = 24; // all that a double below 1 is sure to have
    std::array<glm::dvec3, 3> corners{glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)};
    for (int i = 0; i < digits; ++i) {
        place *= 4;
        const int piece = std::min(int(place), 3);
        place -= piece;
        const std::array<glm::dvec3, 3> middles{0.5 * (corners[1] + corners[2]),
                                                0.5 * (corners[0] + corners[2]),
                                                0.5 * (corners[0] + corners[1])};
        // The one in the middle comes second: it shares a side with each of the others.
        if (piece == 1) {
            corners = middles;
            continue;
        }
        const std::size_t kept = piece == 0 ? 0 : std::size_t(piece) - 1;
        for (std::size_t c = 0; c < 3; ++c)
            if (c != kept) corners[c] = middles[3 - kept - c];
    }
    return (corners[0] + corners[1] + corners[2]) / 3.0;
}

BeamRays readBeams(const Beams& beams, const WaterMesh& surface) {
    const auto vertices = std::size_t(beams.vertexCount), triangles = std::size_t(beams.triangleCount);
    return BeamRays({beams.origins.read<glm::vec4>(vertices), beams.directions.read<glm::vec4>(vertices),
                     surface.indices.read<std::uint32_t>(3 * triangles), beams.flux.read<float>(triangles),
                     beams.lit.read<float>(triangles)});
}

BeamRays::BeamRays(Data data) : _data(std::move(data)) {
    double sum = 0;
    for (std::size_t i = 0; i < _data.flux.size(); ++i)
        _until.push_back(sum += double(_data.flux[i]) * double(_data.lit[i]));
}

BeamRay BeamRays::at(double place) const {
    const double wanted = place * flux();
    const auto found = std::upper_bound(_until.begin(), _until.end() - 1, wanted);
    const std::size_t triangle = std::size_t(found - _until.begin());
    const double before = triangle > 0 ? _until[triangle - 1] : 0;
    const double own = _until[triangle] - before;
    return within(triangle, own > 0 ? std::clamp((wanted - before) / own, 0.0, 1.0) : 0.5);
}

BeamRay BeamRays::within(std::size_t triangle, double place) const {
    const glm::dvec3 weights = trianglePlace(place);
    BeamRay ray{triangle, {}, {}};
    for (int c = 0; c < 3; ++c) {
        const std::uint32_t vertex = _data.indices[3 * triangle + std::size_t(c)];
        ray.from += weights[c] * glm::dvec3(_data.origins[vertex]);
        ray.direction += weights[c] * glm::dvec3(_data.directions[vertex]);
    }
    ray.direction = glm::normalize(ray.direction);
    return ray;
}

} // namespace limpid
