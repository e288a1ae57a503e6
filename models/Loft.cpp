#include "Loft.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace limpid::models {

namespace {

template <typename Blend>
Section blended(Blend&& blend, const Section* s) {
    return {blend(s[0].centre, s[1].centre, s[2].centre, s[3].centre), blend(s[0].a, s[1].a, s[2].a, s[3].a),
            blend(s[0].b, s[1].b, s[2].b, s[3].b)};
}

// The point t ∈ [0, 1] of the way from s[1] to s[2].
Section catmullRom(const Section* s, double t) {
    return blended(
        [t](const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& r, const glm::dvec3& n) {
            return q + 0.5 * t *
                           ((r - p) + t * ((2.0 * p - 5.0 * q + 4.0 * r - n) + t * (3.0 * (q - r) + n - p)));
        },
        s);
}

// What lies beyond an end: its neighbour turned inside out. The axes then cross zero at full speed while the
// centre stands still, which makes the end round and not a cone.
Section beyond(const Section& neighbour) {
    return {neighbour.centre, -neighbour.a, -neighbour.b};
}

std::vector<Section> withEnds(const std::vector<Section>& sections) {
    std::vector<Section> result{beyond(sections[1])};
    result.insert(result.end(), sections.begin(), sections.end());
    result.push_back(beyond(sections[sections.size() - 2]));
    return result;
}

void appendRing(Shell& shell, const Section& section, int sides) {
    for (int side = 0; side < sides; ++side) {
        const double angle = glm::two_pi<double>() * side / sides;
        shell.positions.push_back(section.centre + std::cos(angle) * section.a + std::sin(angle) * section.b);
    }
}

void joinRings(Shell& shell, std::uint32_t ring, std::uint32_t sides) {
    for (std::uint32_t side = 0; side < sides; ++side) {
        const std::uint32_t next = (side + 1) % sides;
        for (std::uint32_t corner : {side, next, sides + next, side, sides + next, sides + side})
            shell.indices.push_back(ring + corner);
    }
}

void joinPole(Shell& shell, std::uint32_t pole, std::uint32_t ring, std::uint32_t sides, bool first) {
    for (std::uint32_t side = 0; side < sides; ++side) {
        const std::uint32_t here = ring + side;
        const std::uint32_t next = ring + (side + 1) % sides;
        shell.indices.insert(shell.indices.end(), {pole, first ? next : here, first ? here : next});
    }
}

} // namespace

Shell loft(const std::vector<Section>& sections, const LoftDetail& detail) {
    const std::vector<Section> all = withEnds(sections);
    const int spans = static_cast<int>(sections.size()) - 1;
    const int rings = spans * detail.ringsPerSpan - 1; // without the two poles
    const auto sides = static_cast<std::uint32_t>(detail.sides);

    Shell shell;
    for (int ring = 1; ring <= rings; ++ring) {
        const int span = ring / detail.ringsPerSpan;
        const double t = double(ring % detail.ringsPerSpan) / detail.ringsPerSpan;
        appendRing(shell, catmullRom(&all[static_cast<std::size_t>(span)], t), detail.sides);
    }
    for (int ring = 0; ring + 1 < rings; ++ring)
        joinRings(shell, static_cast<std::uint32_t>(ring) * sides, sides);

    const auto firstPole = static_cast<std::uint32_t>(shell.positions.size());
    shell.positions.push_back(sections.front().centre);
    shell.positions.push_back(sections.back().centre);
    joinPole(shell, firstPole, 0, sides, true);
    joinPole(shell, firstPole + 1, static_cast<std::uint32_t>(rings - 1) * sides, sides, false);
    return shell;
}

Shell mirroredInZ(Shell shell) {
    for (glm::dvec3& position : shell.positions)
        position.z = -position.z;
    for (std::size_t i = 0; i < shell.indices.size(); i += 3)
        std::swap(shell.indices[i + 1], shell.indices[i + 2]);
    return shell;
}

} // namespace limpid::models
