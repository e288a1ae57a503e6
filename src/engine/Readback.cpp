#include "engine/Readback.h"

#include <algorithm>
#include <cmath>

#include "core/Optics.h"

namespace limpid {

namespace {

/// Σ irradiance · surface area, W, mean of R, G and B.
double depositedFlux(const MapData& map, double texelArea) {
    double sum = 0;
    for (std::size_t i = 0; i < map.normalDotAxis.size(); ++i) {
        if (map.normalDotAxis[i] <= 0) continue;
        const float* rgb = &map.irradiance[3 * i];
        const double mean = (double(rgb[0]) + double(rgb[1]) + double(rgb[2])) / 3;
        sum += mean * texelArea * double(map.coverage[i]) / double(map.normalDotAxis[i]);
    }
    return sum;
}

} // namespace

MapData readMaps(const MapWork& maps, const glm::dvec3& origin, const gl::Texture* coverage) {
    const TexelFrame& frame = maps.level.frame;
    const auto position = maps.level.position.readFloats(GL_RG, 2);
    const auto normal = maps.level.normal.readFloats(GL_RG, 2);
    const auto irradiance = maps.caustics.irradiance.readFloats(GL_RGBA, 4);
    const std::size_t texels = std::size_t(frame.size.x) * std::size_t(frame.size.y);
    MapData data{frame.size,
                 std::vector<float>(3 * texels),
                 std::vector<float>(4 * texels),
                 std::vector<float>(3 * texels),
                 std::vector<float>(texels),
                 coverage ? coverage->readFloats(GL_RED, 1) : std::vector<float>(texels, 1.0f),
                 0};
    for (std::size_t i = 0; i < texels; ++i) {
        if (position[2 * i + 1] == -1.0f) continue;
        const glm::dvec2 texel(double(i % std::size_t(frame.size.x)) + 0.5,
                               double(i / std::size_t(frame.size.x)) + 0.5);
        const glm::dvec3 p = frame.box.point({texel * frame.texel, double(position[2 * i])}) - origin;
        const glm::vec3 n = shader::octahedralDecode({normal[2 * i], normal[2 * i + 1]});
        const double facing = std::abs(glm::dot(glm::dvec3(n), frame.box.t));
        for (int c = 0; c < 3; ++c) {
            data.irradiance[3 * i + std::size_t(c)] = irradiance[4 * i + std::size_t(c)];
            data.position[4 * i + std::size_t(c)] = float(p[c]);
            data.normal[3 * i + std::size_t(c)] = n[c];
        }
        data.position[4 * i + 3] = 1;
        // The octahedral grid is 4e-5 wide: a face that stands closer to the light than that has no area of
        // its own.
        data.normalDotAxis[i] = float(std::max(facing, 4e-5));
    }
    data.deposited = depositedFlux(data, frame.texelArea());
    return data;
}

std::vector<std::uint32_t> planeHistogram(const LevelMap& map) {
    std::vector<std::uint32_t> texels(std::size_t(std::max(map.requestedPlanes, 0)));
    if (!map.position.id()) return {};
    const auto position = map.position.readFloats(GL_RG, 2);
    for (std::size_t i = 1; i < position.size(); i += 2)
        if (position[i] >= 0 && position[i] < float(texels.size())) ++texels[std::size_t(position[i])];
    return texels;
}

} // namespace limpid
