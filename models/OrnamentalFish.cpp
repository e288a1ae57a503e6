#include "FishParts.h"
#include "Models.h"
#include "Shapes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace limpid::models {

namespace {

glm::dvec3 barred(const glm::dvec3& p) {
    const glm::dvec3 colour = glm::mix(rgb(0xE8ECEC), rgb(0xC9B98A), ramp(-0.1, 0.2, p.y));
    double bar = bump(0.262, 0.026, p.x);
    bar = std::max(bar, bump(0.060, 0.048, p.x - 0.1 * p.y * p.y));
    bar = std::max(bar, bump(-0.165, 0.034, p.x));
    return glm::mix(colour, rgb(0x0C0C10), ramp(0.3, 0.6, bar));
}

// The angelfish's fin above (sign 1) or below (−1); the body's bars go on in it.
Shell sail(double sign) {
    Fan f{.root = {{0.120, 0.205 * sign, 0},
                   {0.000, 0.205 * sign, 0},
                   {-0.120, 0.120 * sign, 0},
                   {-0.190, 0.055 * sign, 0}},
          .tip = {{0.060, 0.300 * sign, 0},
                  {-0.170, 0.520 * sign, 0},
                  {-0.290, 0.560 * sign, 0},
                  {-0.235, 0.250 * sign, 0},
                  {-0.225, 0.110 * sign, 0}},
          .halfThickness = 0.008,
          .colour = {},
          .nu = 10,
          .nv = 26};
    f.colour = [f](double u, double v) {
        const glm::dvec3 p = glm::mix(along(f.root, v), along(f.tip, v), u);
        const double ray = 0.12 * (1.0 - std::cos(glm::two_pi<double>() * 13.0 * v));
        return barred({p.x + 0.35 * u * std::abs(p.y), p.y, 0.0}) * (1.0 - ray);
    };
    return fan(f);
}

} // namespace

// The angelfish of aquaria: a disc with sails above and below, feelers, and three black bars.
Mesh angleFish() {
    const Shell round = evenBody({{0.370, 0.010, 0.010, 0.000},
                                  {0.355, 0.034, -0.014, 0.016},
                                  {0.315, 0.070, -0.050, 0.030},
                                  {0.265, 0.116, -0.100, 0.042},
                                  {0.200, 0.172, -0.158, 0.052},
                                  {0.120, 0.218, -0.206, 0.058},
                                  {0.030, 0.232, -0.222, 0.058},
                                  {-0.060, 0.196, -0.190, 0.050},
                                  {-0.130, 0.132, -0.128, 0.038},
                                  {-0.185, 0.078, -0.076, 0.024},
                                  {-0.225, 0.058, -0.056, 0.014},
                                  {-0.265, 0.000, 0.000, 0.000}},
                                 52, 32);
    Assembly fish{swimming(0.0, 0.03)};
    fish.add(withFace(painted(round, barred), {{0.230, 0.0}, 0.095, {0.335, -0.012}, 0.37, 0.008}));
    fish.add(sail(1.0));
    fish.add(sail(-1.0));
    fish.add(fan({.root = {{-0.210, 0.055, 0}, {-0.220, 0, 0}, {-0.210, -0.055, 0}},
                  .tip = {{-0.460, 0.165, 0},
                          {-0.380, 0.080, 0},
                          {-0.365, 0, 0},
                          {-0.380, -0.080, 0},
                          {-0.460, -0.165, 0}},
                  .halfThickness = 0.008,
                  .colour = finColours(0xD8DCD8, 0x9AA09A, 9),
                  .nu = 6,
                  .nv = 24}));
    // The feelers: the pelvic fins' long first rays.
    fish.addPair(painted(
        rod({{0.140, -0.195, 0.022}, {0.100, -0.300, 0.040}, {0.020, -0.430, 0.050}, {-0.100, -0.560, 0.050}},
            {0.012, 0.008, 0.006, 0.003}, 5, 8),
        0xD8DCD0));
    fish.addPair(fan({.root = {{0.150, -0.020, 0.054}, {0.145, -0.060, 0.054}},
                      .tip = {{0.030, 0.010, 0.110}, {0.010, -0.040, 0.115}, {0.040, -0.090, 0.100}},
                      .halfThickness = 0.006,
                      .colour = finColours(0xD0D4D0, 0xB0B4B0, 5),
                      .nu = 4,
                      .nv = 10}));
    fish.addPair(eye({0.270, 0.032, 0.034}, 0.022, 0xD04018));
    return fish.take();
}

Mesh redBetta() {
    const unsigned deep = 0x8C0810, bright = 0xE02820;
    const auto veil = [&](std::vector<glm::dvec3> root, std::vector<glm::dvec3> tip, double ripple,
                          double waves, int rays, glm::ivec2 cells) {
        return fan({.root = std::move(root),
                    .tip = std::move(tip),
                    .halfThickness = 0.007,
                    .ripple = ripple,
                    .waves = waves,
                    .spines = rays,
                    .jag = 0.10,
                    .colour = finColours(deep, bright, 2 * rays),
                    .nu = cells.x,
                    .nv = cells.y});
    };
    const Paint skin = [](const glm::dvec3& p) {
        const double scales = std::sin(170.0 * (p.x + 0.8 * p.y)) * std::sin(170.0 * (p.x - 0.8 * p.y));
        const glm::dvec3 red = glm::mix(rgb(0x7C0A10), rgb(0xB81418), 0.5 + 0.5 * scales);
        return glm::mix(red, rgb(0x3A0A10), ramp(0.34, 0.44, p.x));
    };
    const Shell round = evenBody({{0.500, 0.018, 0.018, 0.000},
                                  {0.488, 0.036, -0.002, 0.014},
                                  {0.450, 0.056, -0.030, 0.030},
                                  {0.400, 0.072, -0.052, 0.042},
                                  {0.330, 0.084, -0.070, 0.050},
                                  {0.250, 0.090, -0.078, 0.052},
                                  {0.150, 0.086, -0.076, 0.048},
                                  {0.060, 0.074, -0.066, 0.040},
                                  {-0.020, 0.060, -0.056, 0.030},
                                  {-0.080, 0.048, -0.046, 0.020},
                                  {-0.120, 0.000, 0.000, 0.000}},
                                 36, 28);
    Assembly fish{swimming(0.1, 0.06)};
    fish.add(withFace(painted(round, skin), {{0.380, 0.0}, 0.090, {0.460, 0.010}, 0.5, 0.018}));
    fish.add(veil({{-0.055, 0.050, 0}, {-0.075, 0, 0}, {-0.055, -0.046, 0}},
                  {{-0.230, 0.330, 0},
                   {-0.420, 0.230, 0},
                   {-0.490, 0.020, 0},
                   {-0.450, -0.210, 0},
                   {-0.250, -0.330, 0}},
                  0.030, 4.0, 14, {10, 42}));
    fish.add(veil({{0.180, 0.080, 0}, {0.100, 0.078, 0}, {0.010, 0.060, 0}},
                  {{0.130, 0.300, 0}, {-0.030, 0.370, 0}, {-0.160, 0.270, 0}}, 0.020, 3.0, 8, {8, 24}));
    fish.add(veil({{0.290, -0.068, 0}, {0.150, -0.072, 0}, {-0.030, -0.050, 0}},
                  {{0.240, -0.200, 0}, {0.080, -0.310, 0}, {-0.200, -0.400, 0}}, 0.022, 4.0, 11, {8, 33}));
    fish.addPair(veil({{0.335, -0.062, 0.020}, {0.310, -0.066, 0.018}},
                      {{0.330, -0.270, 0.070}, {0.270, -0.290, 0.060}, {0.235, -0.240, 0.045}}, 0.006, 1.0, 3,
                      {5, 9}));
    fish.addPair(veil({{0.345, -0.010, 0.050}, {0.340, -0.040, 0.048}},
                      {{0.240, 0.030, 0.120}, {0.215, -0.020, 0.125}, {0.240, -0.075, 0.105}}, 0.004, 2.0, 4,
                      {4, 12}));
    fish.addPair(eye({0.440, 0.028, 0.031}, 0.017, 0x3090A0));
    return fish.take();
}

namespace {

// The wen: a raspberry over brow and cheeks.
double wen(const glm::dvec3& p) {
    const double where = ramp(0.15, 0.26, p.x) * ramp(-0.09, -0.02, p.y + 0.25 * (p.x - 0.30)) *
                         (1.0 - ramp(0.415, 0.45, p.x));
    return where * (0.018 + 0.030 * (1.0 - ramp(0.0, 0.75, scatter(p, 0.060))));
}

Shell lionBody() {
    const Paint skin = [](const glm::dvec3& p) {
        const double scales = std::sin(95.0 * (p.x + 0.8 * p.y)) * std::sin(95.0 * (p.x - 0.8 * p.y));
        const glm::dvec3 gold =
            glm::mix(rgb(0xF6C070), rgb(0xE87818), ramp(-0.17, 0.0, p.y)) * (1.0 + 0.12 * scales);
        const glm::dvec3 head = glm::mix(rgb(0xE0400C), rgb(0xC02808), ramp(0.3, 0.7, scatter(p, 0.060)));
        return glm::mix(gold, head, ramp(0.002, 0.014, wen(p)));
    };
    const Shell round = evenBody({{0.440, -0.028, -0.028, 0.000},
                                  {0.428, 0.014, -0.066, 0.044},
                                  {0.390, 0.066, -0.100, 0.092},
                                  {0.330, 0.110, -0.130, 0.124},
                                  {0.250, 0.144, -0.160, 0.142},
                                  {0.150, 0.168, -0.188, 0.150},
                                  {0.040, 0.176, -0.198, 0.146},
                                  {-0.070, 0.160, -0.180, 0.124},
                                  {-0.160, 0.116, -0.130, 0.086},
                                  {-0.220, 0.070, -0.076, 0.048},
                                  {-0.260, 0.048, -0.050, 0.030},
                                  {-0.300, 0.000, 0.000, 0.000}},
                                 46, 44);
    return swollen(painted(round, skin), wen);
}

} // namespace

// A goldfish without a fin on its back, with a grown head and a double tail.
Mesh lionHead() {
    const unsigned base = 0xF07818, edge = 0xF8D8A8;
    Assembly fish;
    fish.add(lionBody());
    fish.addPair(fan({.root = {{-0.235, 0.062, 0.004}, {-0.262, 0.010, 0.020}, {-0.240, -0.046, 0.012}},
                      .tip = {{-0.420, 0.235, 0.105},
                              {-0.530, 0.120, 0.190},
                              {-0.450, 0.020, 0.215},
                              {-0.520, -0.080, 0.185},
                              {-0.430, -0.180, 0.130}},
                      .halfThickness = 0.008,
                      .ripple = 0.014,
                      .waves = 3.0,
                      .colour = finColours(base, edge, 10),
                      .nu = 7,
                      .nv = 26}));
    fish.addPair(fan({.root = {{-0.110, -0.150, 0.034}, {-0.175, -0.110, 0.030}},
                      .tip = {{-0.190, -0.235, 0.060}, {-0.240, -0.215, 0.062}, {-0.255, -0.155, 0.050}},
                      .colour = finColours(base, edge, 5),
                      .nu = 4,
                      .nv = 10}));
    fish.addPair(fan({.root = {{0.180, -0.110, 0.135}, {0.160, -0.145, 0.120}},
                      .tip = {{0.060, -0.110, 0.250}, {0.030, -0.160, 0.245}, {0.070, -0.205, 0.200}},
                      .colour = finColours(base, edge, 6),
                      .nu = 4,
                      .nv = 12}));
    fish.addPair(fan({.root = {{0.085, -0.180, 0.060}, {0.035, -0.185, 0.055}},
                      .tip = {{0.030, -0.285, 0.110}, {-0.020, -0.280, 0.105}, {-0.030, -0.225, 0.075}},
                      .colour = finColours(base, edge, 6),
                      .nu = 4,
                      .nv = 10}));
    fish.addPair(moved(turned(eye({0.0, 0.0, 0.0}, 0.030, 0xE8C040), 1, 25.0), {0.365, 0.010, 0.118}));
    return fish.take();
}

} // namespace limpid::models
