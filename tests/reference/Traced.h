#pragma once
#include <cmath>
#include <cstdint>

#include "engine/Scenes.h"
#include "reference/ReferenceJob.h"

/// Ground truth in tests: what is traced, and closed forms that share no line with it.
namespace limpid::test {

struct Traced {
    reference::TraceJob job;
    reference::TraceResult result;

    const reference::TexelMap::Finished& map(std::size_t i = 0) const { return result.maps.at(i); }
    const TexelFrame& frame(std::size_t i = 0) const { return job.maps.at(i).frame; }
    glm::ivec2 size(std::size_t i = 0) const { return frame(i).size; }
    const reference::TracedLight& light(std::size_t i = 0) const { return result.lights.at(i); }

    /// Mean of R, G and B; texel (x, y) of map i.
    double irradiance(std::size_t i, int x, int y) const {
        const float* rgb = &map(i).irradiance[3 * std::size_t(y * size(i).x + x)];
        return (double(rgb[0]) + double(rgb[1]) + double(rgb[2])) / 3;
    }
    bool covered(std::size_t i, int x, int y) const {
        return map(i).position[4 * std::size_t(y * size(i).x + x) + 3] == 1;
    }
    glm::dvec3 position(std::size_t i, int x, int y) const {
        const float* p = &map(i).position[4 * std::size_t(y * size(i).x + x)];
        return {p[0], p[1], p[2]};
    }
};

inline Traced trace(const Scene& scene, std::int64_t photons, std::uint64_t seed = 1, int threads = 2) {
    Traced traced{reference::referenceJob(scene, 0), {}};
    traced.result = reference::traceLight(traced.job, {photons, seed, threads, {}});
    return traced;
}

/// Angle of the refracted light, from the vertical, radians.
inline double refractedAngle(double angle, double ior) {
    return std::asin(std::sin(angle) / ior);
}

/// Fresnel's equations by angles: the mean of 1 - sin²(i - t)/sin²(i + t) and 1 - tan²(i - t)/tan²(i + t).
inline double transmittance(double angle, double ior) {
    if (angle < 1e-4) return 1 - std::pow((ior - 1) / (ior + 1), 2);
    const double t = refractedAngle(angle, ior);
    const double s = std::sin(angle - t) / std::sin(angle + t), p = std::tan(angle - t) / std::tan(angle + t);
    return 1 - 0.5 * (s * s + p * p);
}

/// Water of 0.2 m waves over a floor at y = -depth, `size` m along x and z.
inline Scene waveOverFloor(WaveType type, double depth, const glm::dvec2& size, int mapSize) {
    Scene scene;
    Wave wave = scenes::cosine(0.004, 0.2, {1, 0});
    wave.type = type;
    scene.water.waves = {wave};
    scene.lights = {scenes::sunAt(0)};
    scene.receivers = {scenes::shape("floor", makePlane(size, glm::vec3(0.8f)), {0, -depth, 0})};
    scene.caustics.mapSize = mapSize;
    return scene;
}

/// Where the light that falls straight onto y = a cos(k s) at distance s lands on a floor `depth` below the
/// level, and how much of it gets in.
struct Landing {
    double place;
    double transmittance;

    Landing(double s, double amplitude, double k, double depth, double ior) {
        const double slope = std::atan(-amplitude * k * std::sin(k * s));
        const double tilt = slope - std::asin(std::sin(slope) / ior);
        place = s + (depth + amplitude * std::cos(k * s)) * std::tan(tilt);
        transmittance = test::transmittance(std::abs(slope), ior);
    }
};

} // namespace limpid::test
