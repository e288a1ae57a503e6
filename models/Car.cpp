#include "Field.h"
#include "FishParts.h"
#include "Models.h"
#include "Shapes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace limpid::models {

namespace {

// A small round saloon of the middle of the last century. Sizes in its length; the ground is y = 0.

constexpr double frontAxle = 0.295, rearAxle = -0.290, wheelRadius = 0.082, track = 0.158;

Field slabField(const glm::dvec3& low, const glm::dvec3& high, double radius) {
    return [=](const glm::dvec3& p) {
        const glm::dvec3 q = glm::abs(p - 0.5 * (low + high)) - 0.5 * (high - low) + radius;
        return glm::length(glm::max(q, 0.0)) + std::min(std::max({q.x, q.y, q.z}), 0.0) - radius;
    };
}

Field wheelWell(double x) {
    return [=](const glm::dvec3& p) {
        const double radius = glm::distance(glm::dvec2{p}, {x, wheelRadius}) - 0.098;
        return std::max(radius, 0.115 - std::abs(p.z));
    };
}

Field coachwork() {
    const Field shell = joined({ellipsoid({-0.055, 0.180, 0}, {0.300, 0.192, 0.146}),
                                ellipsoid({-0.230, 0.140, 0}, {0.255, 0.160, 0.130}),
                                ellipsoid({0.215, 0.140, 0}, {0.265, 0.118, 0.118}),
                                slabField({-0.360, 0.055, -0.140}, {0.370, 0.170, 0.140}, 0.03)},
                               0.040);
    std::vector<Field> fenders;
    for (double side : {1.0, -1.0}) {
        fenders.push_back(ellipsoid({0.305, 0.098, 0.142 * side}, {0.145, 0.100, 0.050}));
        fenders.push_back(ellipsoid({-0.300, 0.100, 0.142 * side}, {0.150, 0.105, 0.050}));
        fenders.push_back(
            slabField({-0.200, 0.050, 0.152 * side - 0.030}, {0.200, 0.066, 0.152 * side + 0.030}, 0.007));
    }
    const Field body = joined({shell, joined(fenders, 0.010)}, 0.018);
    const Field over = [](const glm::dvec3& p) { return p.y - 0.046; }; // what is cut off below
    return cut(cut(cut(body, wheelWell(frontAxle), 0.006), wheelWell(rearAxle), 0.006), over, 0.006);
}

// How far from `from` the body is along `way`.
double reach(const Field& field, const glm::dvec3& from, const glm::dvec3& way) {
    double t = 0.0;
    for (int i = 0; i < 80; ++i)
        t += 0.6 * field(from + t * way);
    return t;
}

/// A thin pane on the body, seen along `way`: its edges from corner to corner, above and below.
Shell pane(const Field& field, const std::vector<glm::dvec3>& upper, const std::vector<glm::dvec3>& lower,
           const glm::dvec3& way, unsigned colour) {
    return sheet({.middle =
                      [&](double u, double v) {
                          const glm::dvec3 from = glm::mix(along(lower, v), along(upper, v), u);
                          return from + (reach(field, from, way) - 0.0040) * way;
                      },
                  .half = [](double, double) { return 0.0035; },
                  .colour = [&](double, double) { return rgb(colour); },
                  .nu = 4,
                  .nv = 6});
}

void addPanes(Assembly& car, const Field& field) {
    const unsigned glass = 0x16222A;
    const glm::dvec3 inward{0.0, 0.0, -1.0}, back{-1.0, 0.0, 0.0}, ahead{1.0, 0.0, 0.0};
    const double far = 0.3;
    car.addPair(pane(field, {{0.092, 0.318, far}, {0.060, 0.337, far}, {-0.010, 0.340, far}},
                     {{0.140, 0.250, far}, {0.080, 0.246, far}, {-0.010, 0.246, far}}, inward, glass));
    car.addPair(pane(field, {{-0.030, 0.340, far}, {-0.110, 0.333, far}, {-0.180, 0.300, far}},
                     {{-0.030, 0.246, far}, {-0.110, 0.246, far}, {-0.215, 0.252, far}}, inward, glass));
    car.add(pane(field, {{0.6, 0.335, 0.062}, {0.6, 0.341, 0.0}, {0.6, 0.335, -0.062}},
                 {{0.6, 0.266, 0.084}, {0.6, 0.264, 0.0}, {0.6, 0.266, -0.084}}, back, glass));
    car.add(pane(field, {{-0.6, 0.325, -0.062}, {-0.6, 0.332, 0.0}, {-0.6, 0.325, 0.062}},
                 {{-0.6, 0.282, -0.075}, {-0.6, 0.282, 0.0}, {-0.6, 0.282, 0.075}}, ahead, glass));
    car.add(pane(field, {{-0.6, 0.205, -0.030}, {-0.6, 0.208, 0.0}, {-0.6, 0.205, 0.030}},
                 {{-0.6, 0.175, -0.034}, {-0.6, 0.175, 0.0}, {-0.6, 0.175, 0.034}}, ahead,
                 0xE8E4D0)); // number plate
}

Shell tyre() {
    const double r = wheelRadius;
    return lathe({{0.60 * r, -0.020},
                  {0.90 * r, -0.024},
                  {0.98 * r, -0.018},
                  {r, 0.0},
                  {0.98 * r, 0.018},
                  {0.90 * r, 0.024},
                  {0.60 * r, 0.020}},
                 28);
}

Shell hub() {
    return smoothLathe(
        {{0.0, -0.015}, {0.052, -0.015}, {0.052, 0.014}, {0.036, 0.016}, {0.030, 0.024}, {0.0, 0.029}}, 2,
        22);
}

void addWheels(Assembly& car) {
    for (double x : {frontAxle, rearAxle}) {
        const auto placed = [&](const Shell& shell) {
            return moved(turned(shell, 0, 90.0), {x, wheelRadius, track});
        };
        car.addPair(painted(placed(tyre()), 0x141414));
        car.addPair(painted(placed(hub()), [&](const glm::dvec3& p) {
            const double r = glm::distance(glm::dvec2{p}, {x, wheelRadius});
            return r < 0.040 ? rgb(0xD8DCDE) : rgb(0xE8E0C8);
        }));
    }
}

void addFittings(Assembly& car) {
    const unsigned chrome = 0xD0D4D8;
    for (double end : {1.0, -1.0})
        car.add(painted(rod({{0.380 * end, 0.092, -0.165},
                             {0.478 * end, 0.092, -0.125},
                             {0.498 * end, 0.092, 0.0},
                             {0.478 * end, 0.092, 0.125},
                             {0.380 * end, 0.092, 0.165}},
                            {0.009, 0.010, 0.010, 0.010, 0.009}, 4, 8),
                        chrome));
    for (double z : {0.075, -0.075})
        for (double end : {1.0, -1.0})
            car.add(painted(cushion({0.492 * end, 0.094, z}, {0.011, 0.026, 0.009}, 3.0, 3), chrome));
    // Lamps: a glass in a chrome ring, looking ahead.
    const auto lamp = [&](double radius, unsigned glass, const glm::dvec3& at, double tilt) {
        const Shell ring =
            lathe({{0.0, -0.030}, {radius, -0.030}, {1.1 * radius, 0.0}, {radius, 0.006}, {0.0, 0.006}}, 18);
        const Shell lens =
            smoothLathe({{0.0, 0.0}, {0.93 * radius, 0.004}, {0.7 * radius, 0.012}, {0.0, 0.016}}, 2, 18);
        car.addPair(painted(moved(turned(ring, 2, tilt), at), chrome));
        car.addPair(painted(moved(turned(lens, 2, tilt), at), glass));
    };
    lamp(0.036, 0xF6F2DC, {0.408, 0.162, 0.140}, -68.0);
    lamp(0.018, 0xB01810, {-0.412, 0.150, 0.142}, 68.0);
    car.addPair(painted(rod({{-0.025, 0.222, 0.150}, {-0.045, 0.222, 0.156}, {-0.065, 0.222, 0.150}},
                            {0.004, 0.005, 0.004}, 3, 6),
                        chrome));
    car.add(painted(
        rod({{0.270, 0.257, 0}, {0.360, 0.241, 0}, {0.435, 0.208, 0}}, {0.003, 0.005, 0.004}, 4, 6), chrome));
}

} // namespace

Mesh car() {
    Assembly car;
    const Field field = coachwork();
    const Shell body = surfaceOf(field, {-0.52, 0.02, -0.22}, {0.52, 0.40, 0.22}, 0.0085, 4300);
    car.add(painted(body, 0x4E8FA0), 42.0);
    addPanes(car, field);
    addWheels(car);
    addFittings(car);
    return car.take();
}

} // namespace limpid::models
