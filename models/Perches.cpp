#include "FishParts.h"
#include "Models.h"

#include <glm/common.hpp>

#include <cmath>

namespace limpid::models {

namespace {

Shell fanPart(const std::vector<glm::dvec3>& root, const std::vector<glm::dvec3>& tip, unsigned base,
              unsigned edge, int rays, glm::ivec2 cells, int spines = 0, double jag = 0.0) {
    return fan({.root = root,
                .tip = tip,
                .halfThickness = 0.007,
                .spines = spines,
                .jag = jag,
                .colour = finColours(base, edge, rays),
                .nu = cells.x,
                .nv = cells.y});
}

} // namespace

Mesh barramundi() {
    const unsigned fin = 0x5A5648, edge = 0x34322C;
    const Paint skin = [](const glm::dvec3& p) {
        const glm::dvec3 low = glm::mix(rgb(0xF2F0E4), rgb(0xB9B49C), ramp(-0.13, -0.02, p.y));
        const glm::dvec3 colour = glm::mix(low, rgb(0x4C5140), ramp(0.0, 0.13, p.y));
        const double scales = std::sin(150.0 * (p.x + 0.7 * p.y)) * std::sin(150.0 * (p.x - 0.7 * p.y));
        return colour * (1.0 + 0.14 * scales * (1.0 - ramp(0.20, 0.28, p.x)));
    };
    // The dished head that rises to a humped back.
    const Shell round = evenBody({{0.500, -0.048, -0.048, 0.000},
                                  {0.488, -0.030, -0.066, 0.016},
                                  {0.450, -0.006, -0.084, 0.034},
                                  {0.400, 0.018, -0.102, 0.048},
                                  {0.345, 0.042, -0.118, 0.058},
                                  {0.290, 0.084, -0.130, 0.066},
                                  {0.220, 0.130, -0.138, 0.070},
                                  {0.130, 0.150, -0.140, 0.070},
                                  {0.020, 0.146, -0.130, 0.064},
                                  {-0.090, 0.122, -0.110, 0.054},
                                  {-0.190, 0.086, -0.080, 0.040},
                                  {-0.270, 0.056, -0.056, 0.027},
                                  {-0.330, 0.050, -0.050, 0.018},
                                  {-0.390, 0.000, 0.000, 0.000}},
                                 60, 30);
    const Face face{{0.340, -0.030}, 0.130, {0.370, -0.078}, 0.5, -0.050};
    Assembly fish{swimming(0.1, 0.05)};
    fish.add(withFace(painted(round, skin), face));
    // Tail: a rounded paddle.
    fish.add(fanPart(
        {{-0.320, 0.045, 0}, {-0.330, 0, 0}, {-0.320, -0.045, 0}},
        {{-0.430, 0.120, 0}, {-0.490, 0.075, 0}, {-0.505, 0, 0}, {-0.490, -0.075, 0}, {-0.430, -0.120, 0}},
        fin, edge, 9, {6, 24}));
    fish.add(fanPart({{0.190, 0.130, 0}, {0.110, 0.142, 0}, {0.020, 0.135, 0}},
                     {{0.150, 0.205, 0}, {0.080, 0.255, 0}, {-0.020, 0.175, 0}}, fin, edge, 0, {5, 28}, 7,
                     0.40));
    fish.add(fanPart({{0.005, 0.132, 0}, {-0.080, 0.112, 0}, {-0.170, 0.080, 0}},
                     {{-0.020, 0.200, 0}, {-0.120, 0.195, 0}, {-0.220, 0.125, 0}}, fin, edge, 8, {5, 18}));
    fish.add(fanPart({{-0.090, -0.095, 0}, {-0.150, -0.085, 0}, {-0.200, -0.065, 0}},
                     {{-0.125, -0.170, 0}, {-0.200, -0.165, 0}, {-0.240, -0.110, 0}}, fin, edge, 6, {5, 14}));
    fish.addPair(fanPart({{0.225, -0.060, 0.060}, {0.215, -0.090, 0.058}},
                         {{0.110, -0.060, 0.125}, {0.095, -0.100, 0.120}, {0.135, -0.130, 0.090}}, fin, edge,
                         5, {4, 12}));
    fish.addPair(fanPart({{0.160, -0.120, 0.030}, {0.120, -0.122, 0.028}},
                         {{0.100, -0.195, 0.060}, {0.060, -0.190, 0.055}, {0.060, -0.150, 0.035}}, fin, edge,
                         5, {4, 10}));
    fish.addPair(eye({0.408, -0.014, 0.033}, 0.018, 0xE0B040));
    return fish.take();
}

Mesh siameseTiger() {
    const unsigned gold = 0xE6B43C, dark = 0x14100A;
    const auto bars = [](double x, double y) {
        double bar = 0.0;
        for (double centre : {0.300, 0.155, 0.000, -0.150, -0.285})
            bar = std::max(bar, bump(centre + 0.10 * y * y, 0.046 + 0.03 * std::abs(y), x));
        return ramp(0.25, 0.55, bar);
    };
    const Paint skin = [=](const glm::dvec3& p) {
        const glm::dvec3 colour = glm::mix(rgb(0xF6E2A0), rgb(0xD89A28), ramp(-0.16, 0.20, p.y));
        // The first stripe runs through the eye to the brow.
        const double mask = bump(0.405 - 0.35 * p.y, 0.026, p.x);
        return glm::mix(colour, rgb(dark), std::max(bars(p.x, p.y), ramp(0.3, 0.6, mask)));
    };
    const Shell round = evenBody({{0.500, -0.050, -0.050, 0.000},
                                  {0.485, -0.026, -0.072, 0.018},
                                  {0.440, 0.008, -0.096, 0.034},
                                  {0.385, 0.042, -0.122, 0.046},
                                  {0.330, 0.084, -0.146, 0.056},
                                  {0.265, 0.140, -0.168, 0.062},
                                  {0.180, 0.194, -0.190, 0.066},
                                  {0.080, 0.216, -0.200, 0.066},
                                  {-0.030, 0.206, -0.194, 0.060},
                                  {-0.130, 0.168, -0.164, 0.050},
                                  {-0.220, 0.116, -0.116, 0.036},
                                  {-0.290, 0.074, -0.074, 0.024},
                                  {-0.335, 0.064, -0.064, 0.016},
                                  {-0.385, 0.000, 0.000, 0.000}},
                                 62, 34);
    const Face face{{0.330, -0.030}, 0.140, {0.395, -0.086}, 0.5, -0.054};
    Assembly fish{swimming(0.0, 0.03)};
    fish.add(withFace(painted(round, skin), face));
    fish.add(fanPart(
        {{-0.320, 0.058, 0}, {-0.330, 0, 0}, {-0.320, -0.058, 0}},
        {{-0.450, 0.120, 0}, {-0.490, 0.070, 0}, {-0.500, 0, 0}, {-0.490, -0.070, 0}, {-0.450, -0.120, 0}},
        gold, 0xF0D890, 9, {6, 22}));
    fish.add(fanPart({{0.150, 0.200, 0}, {0.040, 0.208, 0}, {-0.080, 0.185, 0}},
                     {{0.110, 0.265, 0}, {0.000, 0.300, 0}, {-0.120, 0.235, 0}}, dark, 0x3A2A10, 0, {4, 30},
                     10, 0.45));
    fish.add(fanPart({{-0.090, 0.180, 0}, {-0.170, 0.140, 0}, {-0.260, 0.085, 0}},
                     {{-0.130, 0.255, 0}, {-0.260, 0.235, 0}, {-0.330, 0.140, 0}}, gold, dark, 7, {5, 16}));
    fish.add(fanPart({{-0.080, -0.175, 0}, {-0.170, -0.138, 0}, {-0.260, -0.085, 0}},
                     {{-0.120, -0.260, 0}, {-0.260, -0.235, 0}, {-0.330, -0.140, 0}}, gold, dark, 7,
                     {5, 16}));
    fish.addPair(fanPart({{0.215, -0.055, 0.058}, {0.205, -0.090, 0.056}},
                         {{0.095, -0.050, 0.120}, {0.080, -0.095, 0.115}, {0.125, -0.130, 0.085}}, gold,
                         0xF0D890, 5, {4, 10}));
    fish.addPair(fanPart({{0.165, -0.178, 0.024}, {0.115, -0.186, 0.022}},
                         {{0.080, -0.310, 0.060}, {0.040, -0.290, 0.055}, {0.045, -0.220, 0.030}}, dark,
                         0x3A2A10, 4, {4, 10}));
    fish.addPair(eye({0.398, -0.008, 0.030}, 0.021, 0xC03010));
    return fish.take();
}

Mesh bass() {
    const unsigned fin = 0x6A7440, edge = 0x4A5230;
    const Paint skin = [](const glm::dvec3& p) {
        const glm::dvec3 low = glm::mix(rgb(0xF0EEDC), rgb(0x9AA45C), ramp(-0.11, -0.03, p.y));
        const glm::dvec3 colour = glm::mix(low, rgb(0x2E4220), ramp(0.0, 0.11, p.y));
        // A ragged dark band from gill to tail.
        const double ragged = 0.018 + 0.020 * noise({p.x, 0.0, 0.0}, 0.05);
        return glm::mix(colour, rgb(0x141C10),
                        0.85 * bump(0.004, 2.0 * ragged, p.y) * (1.0 - ramp(0.28, 0.34, p.x)));
    };
    Assembly fish{swimming(0.1, 0.10)};
    // The mouth stands open: an upper head with the trunk, and a lower jaw of its own.
    const Shell round = evenBody({{0.480, 0.012, 0.012, 0.000},
                                  {0.462, 0.030, -0.014, 0.026},
                                  {0.400, 0.060, -0.040, 0.048},
                                  {0.320, 0.094, -0.096, 0.060},
                                  {0.220, 0.130, -0.138, 0.070},
                                  {0.090, 0.142, -0.142, 0.070},
                                  {-0.060, 0.120, -0.116, 0.056},
                                  {-0.190, 0.082, -0.078, 0.038},
                                  {-0.300, 0.050, -0.048, 0.020},
                                  {-0.360, 0.000, 0.000, 0.000}},
                                 26, 18);
    fish.add(withFace(painted(round, skin), {{0.300, -0.010}, 0.125, {0.470, 0.0}, 0.48, 0.01}));
    fish.add(painted(body({{0.494, -0.036, -0.036, 0.000},
                           {0.478, -0.022, -0.056, 0.022},
                           {0.410, -0.030, -0.092, 0.043},
                           {0.330, -0.040, -0.114, 0.050},
                           {0.250, -0.090, -0.090, 0.000}},
                          {.ringsPerSpan = 2, .sides = 14}),
                     [&](const glm::dvec3& p) { return p.y > -0.040 ? rgb(0x6A3028) : skin(p); }));
    fish.add(fanPart(
        {{-0.300, 0.042, 0}, {-0.310, 0, 0}, {-0.300, -0.042, 0}},
        {{-0.480, 0.130, 0}, {-0.465, 0.060, 0}, {-0.440, 0, 0}, {-0.465, -0.060, 0}, {-0.480, -0.130, 0}},
        fin, edge, 6, {4, 14}));
    fish.add(fanPart({{0.160, 0.128, 0}, {0.080, 0.135, 0}, {-0.010, 0.122, 0}},
                     {{0.120, 0.205, 0}, {0.040, 0.215, 0}, {-0.045, 0.150, 0}}, fin, edge, 0, {3, 14}, 7,
                     0.35));
    fish.add(fanPart({{-0.030, 0.115, 0}, {-0.090, 0.100, 0}, {-0.170, 0.075, 0}},
                     {{-0.060, 0.205, 0}, {-0.150, 0.195, 0}, {-0.215, 0.115, 0}}, fin, edge, 6, {3, 12}));
    fish.add(fanPart({{-0.090, -0.098, 0}, {-0.140, -0.085, 0}, {-0.190, -0.070, 0}},
                     {{-0.120, -0.175, 0}, {-0.190, -0.165, 0}, {-0.225, -0.105, 0}}, fin, edge, 5, {3, 8}));
    fish.addPair(fanPart({{0.230, -0.060, 0.062}, {0.215, -0.090, 0.060}},
                         {{0.120, -0.050, 0.125}, {0.105, -0.095, 0.120}, {0.145, -0.130, 0.090}}, fin, edge,
                         4, {3, 6}));
    fish.addPair(fanPart({{0.160, -0.122, 0.030}, {0.120, -0.125, 0.028}},
                         {{0.100, -0.195, 0.060}, {0.060, -0.190, 0.055}, {0.070, -0.150, 0.035}}, fin, edge,
                         4, {3, 6}));
    fish.addPair(eye({0.395, 0.028, 0.036}, 0.018, 0xC8A030));
    return fish.take();
}

} // namespace limpid::models
