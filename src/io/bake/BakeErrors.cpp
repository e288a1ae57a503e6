#include "io/bake/BakeErrors.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/Error.h"

namespace limpid::io {

namespace {

const BakedMap* findMap(const Bake& bake, const BakedMap& wanted) {
    for (const BakedMap& map : bake.maps)
        if (map.receiver == wanted.receiver && map.light == wanted.light && map.facing == wanted.facing)
            return &map;
    return nullptr;
}

/// The counterpart of every map of `b` in `a`.
const BakedMap& requireMap(const Bake& a, const BakedMap& wanted, const std::string& nameA,
                           const std::string& nameB) {
    const BakedMap* map = findMap(a, wanted);
    if (!map)
        throw InputError(
            fmt::format("{}: expected a map of {} as in {}, found none", nameA, mapTitle(wanted), nameB));
    return *map;
}

/// Texels by which the two frames put a corner of the map apart, at most.
double frameDistance(const BakedMap& a, const BakedMap& b, const glm::dvec3& originA,
                     const glm::dvec3& originB) {
    const glm::dmat4 toWorld = glm::inverse(b.worldToTexture);
    double apart = 0;
    for (int corner = 0; corner < 4; ++corner) {
        const glm::dvec2 uv(corner % 2, corner / 2);
        const glm::dvec4 world = toWorld * glm::dvec4(uv, 0.5, 1) + glm::dvec4(originB - originA, 0);
        const glm::dvec2 difference = (glm::dvec2(a.worldToTexture * world) - uv) * glm::dvec2(b.size);
        apart = std::max(apart, glm::length(difference));
    }
    return apart;
}

bool sees(const BakedMap& map, std::size_t texel) {
    return map.position[4 * texel + 3] > 0;
}

/// Rows of the matrix are the box's axes, each divided by its extent.
glm::dvec3 row(const glm::dmat4& matrix, int index) {
    return {matrix[0][index], matrix[1][index], matrix[2][index]};
}

void fillMask(MapPair& pair) {
    const BakedMap& b = *pair.b;
    const std::size_t texels = std::size_t(b.size.x) * std::size_t(b.size.y);
    const glm::dvec3 axis = glm::normalize(row(b.worldToTexture, 2));
    const double footprint =
        1 / (glm::length(row(b.worldToTexture, 0)) * glm::length(row(b.worldToTexture, 1)) * double(texels));
    pair.mask.assign(texels, 0);
    pair.area.assign(texels, 0);
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < texels; ++i) {
        if (sees(*pair.a, i) != sees(b, i)) ++pair.unmatched;
        if (!sees(*pair.a, i) || !sees(b, i)) continue;
        const glm::dvec3 normal(b.normal[3 * i], b.normal[3 * i + 1], b.normal[3 * i + 2]);
        pair.mask[i] = 1;
        // No face counts as steeper than what a baked normal can say (engine/Readback.cpp).
        pair.area[i] = float(footprint / std::max(std::abs(glm::dot(normal, axis)), 4e-5));
        for (std::size_t c = 3 * i; c < 3 * i + 3; ++c)
            if (std::isfinite(b.irradiance[c])) sum += b.irradiance[c], ++count;
    }
    if (sum > 0) pair.white = sum / double(count) / 0.18;
}

} // namespace

std::string mapTitle(const BakedMap& map) {
    std::string title = fmt::format("{} in {}", map.receiver, map.light);
    if (map.facing > 0) title += fmt::format(", facing {}", map.facing);
    return title;
}

std::vector<MapPair> pairMaps(const Bake& a, const Bake& b, const std::string& nameA,
                              const std::string& nameB) {
    for (const BakedMap& map : a.maps)
        requireMap(b, map, nameB, nameA);
    std::vector<MapPair> pairs;
    for (const BakedMap& map : b.maps) {
        MapPair& pair = pairs.emplace_back();
        pair.a = &requireMap(a, map, nameA, nameB);
        pair.b = &map;
        if (pair.a->size != map.size)
            throw InputError(fmt::format("{}: {}: expected {} x {} texels as in {}, found {} x {}", nameA,
                                         mapTitle(map), map.size.x, map.size.y, nameB, pair.a->size.x,
                                         pair.a->size.y));
        if (const double apart = frameDistance(*pair.a, map, a.origin, b.origin); !(apart <= mostApart))
            throw InputError(
                fmt::format("{}: {}: expected texels where {} has them, found them {:.3g} texels "
                            "away",
                            nameA, mapTitle(map), nameB, apart));
        fillMask(pair);
    }
    return pairs;
}

ImageErrors bakeErrors(const Bake& a, const Bake& b, const std::string& nameA, const std::string& nameB) {
    std::vector<float> valuesA, valuesB, mask, area;
    const auto append = [](std::vector<float>& to, const std::vector<float>& from) {
        to.insert(to.end(), from.begin(), from.end());
    };
    double white = 0, compared = 0;
    for (const MapPair& pair : pairMaps(a, b, nameA, nameB)) {
        append(valuesA, pair.a->irradiance);
        append(valuesB, pair.b->irradiance);
        append(mask, pair.mask);
        append(area, pair.area);
        const auto own = double(std::count(pair.mask.begin(), pair.mask.end(), 1.0f));
        white += own * pair.white;
        compared += own;
    }
    return imageErrors({valuesA, valuesB, mask, area, 0, compared > 0 ? white / compared : 1});
}

std::optional<double> standardError(const Bake& truth) {
    // Absolute errors add up; each map's is given over its own mean.
    double errors = 0, light = 0;
    for (const BakedMap& map : truth.maps) {
        if (!map.standardError) return std::nullopt;
        double sum = 0;
        for (const float value : map.irradiance)
            if (std::isfinite(value)) sum += value;
        errors += *map.standardError * sum;
        light += sum;
    }
    return light > 0 ? std::optional(errors / light) : std::nullopt;
}

} // namespace limpid::io
