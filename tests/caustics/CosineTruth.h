#pragma once
#include <cmath>
#include <vector>

#include "core/Optics.h"

namespace limpid {

/// Irradiance under one cosine wave y = a cos(2π x / wavelength) over a floor, light straight down, 1 W/m²
/// (physics.md, known truths): means over texels of width 1 / `texelsPerMetre` from `begin` (m), by equally
/// spaced rays in double precision, each spread over the footprint between it and its neighbour.
struct CosineTruth {
    double amplitude = 0.004, wavelength = 0.2, depth = 1, ior = 1.333;

    /// Where the ray that meets the surface at x lands, m; its Fresnel transmittance.
    std::pair<double, double> land(double x) const {
        const double k = 2 * M_PI / wavelength;
        const double height = amplitude * std::cos(k * x), slope = -amplitude * k * std::sin(k * x);
        const glm::dvec3 normal = glm::normalize(glm::dvec3(-slope, 1, 0));
        const glm::dvec3 ray = optics::refractDirection({0, -1, 0}, normal, 1 / ior);
        return {x + (depth + height) * ray.x / -ray.y, optics::fresnelTransmittance(normal.y, 1 / ior)};
    }

    std::vector<double> texels(double begin, int count, double texelsPerMetre,
                               int raysPerTexel = 2000) const {
        std::vector<double> sums(std::size_t(count), 0.0);
        const double margin = 0.2, step = 1 / texelsPerMetre / raysPerTexel;
        const auto rays = std::int64_t((count / texelsPerMetre + 2 * margin) / step);
        auto last = land(begin - margin);
        for (std::int64_t i = 1; i <= rays; ++i) {
            const auto next = land(begin - margin + double(i) * step);
            spread(sums, (last.first - begin) * texelsPerMetre, (next.first - begin) * texelsPerMetre,
                   0.5 * (last.second + next.second) / raysPerTexel);
            last = next;
        }
        return sums;
    }

  private:
    static void spread(std::vector<double>& sums, double a, double b, double flux) {
        if (a > b) std::swap(a, b);
        const double width = std::max(b - a, 1e-12);
        for (auto t = std::int64_t(std::floor(a)); t <= std::int64_t(std::floor(b)); ++t) {
            if (t < 0 || t >= std::int64_t(sums.size())) continue;
            const double inside = std::min(b, double(t + 1)) - std::max(a, double(t));
            sums[std::size_t(t)] += flux * std::max(inside, b - a > 0 ? 0.0 : width) / width;
        }
    }
};

} // namespace limpid
