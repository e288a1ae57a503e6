#include "FishParts.h"
#include "Models.h"
#include "Shapes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace limpid::models {

namespace {

Shell wing(const std::vector<glm::dvec3>& root, const std::vector<glm::dvec3>& tip, double halfThickness,
           unsigned colour, glm::ivec2 cells) {
    return fan({.root = root,
                .tip = tip,
                .halfThickness = halfThickness,
                .colour = finColours(colour, colour),
                .nu = cells.x,
                .nv = cells.y});
}

Shell fuselage() {
    const Shell tube = evenBody({{0.500, -0.012, -0.012, 0.000},
                                 {0.492, 0.008, -0.030, 0.018},
                                 {0.470, 0.026, -0.042, 0.034},
                                 {0.435, 0.044, -0.050, 0.046},
                                 {0.390, 0.053, -0.053, 0.052},
                                 {0.300, 0.054, -0.054, 0.054},
                                 {0.100, 0.054, -0.054, 0.054},
                                 {-0.150, 0.054, -0.054, 0.054},
                                 {-0.280, 0.054, -0.040, 0.047},
                                 {-0.390, 0.052, 0.000, 0.029},
                                 {-0.460, 0.050, 0.026, 0.012},
                                 {-0.490, 0.042, 0.042, 0.000}},
                                44, 20);
    return painted(tube, [](const glm::dvec3& p) {
        const bool cockpit = p.x > 0.430 && p.x < 0.468 && p.y > 0.014;
        const glm::dvec3 body = glm::mix(rgb(0xB4BAC0), rgb(0xF4F4F2), ramp(-0.030, -0.022, p.y));
        const double stripe = bump(0.006, 0.016, p.y) * ramp(-0.47, -0.44, p.x);
        return cockpit ? rgb(0x14181C) : glm::mix(body, rgb(0x1C4C9C), ramp(0.2, 0.5, stripe));
    });
}

Shell engine() {
    const Shell pod = lathe({{0.0, -0.075},
                             {0.016, -0.060},
                             {0.024, -0.050},
                             {0.033, -0.010},
                             {0.036, 0.040},
                             {0.033, 0.060},
                             {0.027, 0.058},
                             {0.026, 0.040},
                             {0.0, 0.030}},
                            14);
    return painted(turned(pod, 2, -90.0), [](const glm::dvec3& p) {
        const double radius = std::hypot(p.y, p.z);
        return p.x > 0.025 && radius < 0.0275 ? rgb(0x181C20) : p.x < -0.045 ? rgb(0x606468) : rgb(0x1C4C9C);
    });
}

} // namespace

// An airliner in flight, wheels up.
Mesh plane() {
    const unsigned grey = 0xB4BAC0, blue = 0x1C4C9C;
    Assembly plane;
    plane.add(fuselage());
    plane.addPair(wing({{0.130, -0.028, 0.030}, {0.030, -0.030, 0.030}, {-0.070, -0.030, 0.030}},
                       {{-0.105, 0.022, 0.460}, {-0.125, 0.022, 0.462}, {-0.145, 0.022, 0.460}}, 0.013, grey,
                       {6, 8}));
    // Upturned tips.
    plane.addPair(wing({{-0.103, 0.020, 0.455}, {-0.145, 0.020, 0.457}},
                       {{-0.145, 0.066, 0.476}, {-0.165, 0.066, 0.476}}, 0.005, blue, {3, 4}));
    plane.addPair(wing({{-0.360, 0.030, 0.010}, {-0.405, 0.032, 0.010}, {-0.450, 0.034, 0.010}},
                       {{-0.455, 0.046, 0.165}, {-0.475, 0.046, 0.166}, {-0.490, 0.046, 0.165}}, 0.009, grey,
                       {4, 6}));
    plane.add(wing({{-0.300, 0.045, 0}, {-0.375, 0.045, 0}, {-0.455, 0.045, 0}},
                   {{-0.450, 0.212, 0}, {-0.478, 0.214, 0}, {-0.505, 0.212, 0}}, 0.010, blue, {5, 8}));
    const glm::dvec3 mount{0.085, -0.068, 0.155};
    plane.addPair(moved(engine(), mount));
    const Shell pylon =
        slab({{-0.060, 0.010}, {0.035, 0.020}, {-0.010, 0.056}, {-0.080, 0.056}}, -0.004, 0.004);
    plane.addPair(moved(painted(pylon, grey), mount));
    return plane.take();
}

namespace {

// A bay of the tail boom: two upper and one lower rail, posts and diagonals between its stations.
void addBoom(Assembly& craft, unsigned colour) {
    const int bays = 7;
    const auto station = [&](int i, int rail) {
        const double t = double(i) / bays;
        const double x = glm::mix(-0.060, -0.440, t), h = glm::mix(1.0, 0.30, t);
        const glm::dvec3 corner = rail == 0   ? glm::dvec3{0.0, 0.055, 0.060}
                                  : rail == 1 ? glm::dvec3{0.0, 0.055, -0.060}
                                              : glm::dvec3{0.0, -0.065, 0.0};
        return glm::dvec3{x, 0.300 + 0.035 * t, 0.0} + h * corner;
    };
    const auto bar = [&](const glm::dvec3& a, const glm::dvec3& b, double radius) {
        craft.add(painted(rod({a, b}, {radius, radius}, 1, 6), colour));
    };
    for (int rail = 0; rail < 3; ++rail) {
        bar(station(0, rail), station(bays, rail), 0.0055);
        for (int i = 1; i <= bays; ++i)
            bar(station(i, rail), station(i, (rail + 1) % 3), 0.0035);
        for (int i = 0; i < bays; ++i)
            bar(station(i, rail), station(i + 1, (rail + 1) % 3), 0.0035);
    }
}

// A blade along z with a rotor's section.
Shell blade(double from, double to, double chord) {
    return fan({.root = {{0.5 * chord, 0, from}, {0.0, 0.004, from}, {-0.5 * chord, 0, from}},
                .tip = {{0.5 * chord, 0, to}, {0.0, 0.004, to}, {-0.5 * chord, 0, to}},
                .halfThickness = 0.006,
                .colour = finColours(0x3A3E42, 0x3A3E42),
                .nu = 8,
                .nv = 4});
}

void addRotors(Assembly& craft) {
    const auto spun = [](const Shell& shell) { return moved(turned(shell, 1, 105.0), {-0.020, 0.515, 0.0}); };
    const Shell one = blade(0.020, 0.500, 0.046);
    for (double turn : {0.0, 180.0})
        craft.add(spun(turned(one, 1, turn)));
    craft.add(
        painted(
            spun(lathe({{0.0, -0.024}, {0.026, -0.020}, {0.026, 0.010}, {0.014, 0.024}, {0.0, 0.026}}, 14)),
            0x50565C),
        30.0);
    craft.add(painted(spun(rod({{-0.120, -0.030, 0}, {0.120, -0.030, 0}}, {0.004, 0.004}, 1, 6)),
                      0x808890)); // stabilizer
    for (double end : {-0.120, 0.120})
        craft.add(painted(spun(moved(globe({0, 0, 0}, 0.014, 6, 8), {end, -0.030, 0})), 0x808890));
    craft.add(painted(rod({{-0.020, 0.330, 0}, {-0.020, 0.500, 0}}, {0.014, 0.010}, 1, 10), 0x70787E));
    // The tail rotor turns in the plane of the boom.
    const Shell small = turned(turned(blade(0.010, 0.095, 0.022), 1, 90.0), 0, 90.0);
    for (double turn : {35.0, 215.0})
        craft.add(moved(turned(small, 2, turn), {-0.452, 0.340, 0.030}));
    craft.add(
        painted(rod({{-0.452, 0.340, -0.010}, {-0.452, 0.340, 0.038}}, {0.010, 0.008}, 1, 8), 0x50565C));
    // Its guard.
    craft.add(painted(rod({{-0.420, 0.310, 0}, {-0.450, 0.230, 0}, {-0.510, 0.200, 0}, {-0.560, 0.215, 0}},
                          {0.005, 0.005, 0.005, 0.004}, 3, 6),
                      0x808890));
    craft.add(fan({.root = {{-0.370, 0.335, -0.015}, {-0.410, 0.335, -0.015}},
                   .tip = {{-0.385, 0.335, -0.110}, {-0.420, 0.335, -0.110}},
                   .halfThickness = 0.004,
                   .colour = finColours(0xD8A020, 0xD8A020),
                   .nu = 3,
                   .nv = 4}));
}

void addSkids(Assembly& craft) {
    const unsigned steel = 0x70787E;
    for (double x : {0.130, -0.050})
        craft.add(painted(rod({{x, 0.012, -0.135},
                               {x, 0.120, -0.085},
                               {x, 0.150, 0.0},
                               {x, 0.120, 0.085},
                               {x, 0.012, 0.135}},
                              {0.007, 0.007, 0.007, 0.007, 0.007}, 3, 8),
                          steel));
    for (double side : {1.0, -1.0}) {
        craft.add(painted(rod({{0.270, 0.070, 0.135 * side},
                               {0.230, 0.022, 0.135 * side},
                               {0.150, 0.010, 0.135 * side},
                               {-0.060, 0.010, 0.135 * side},
                               {-0.170, 0.014, 0.135 * side}},
                              {0.007, 0.008, 0.008, 0.008, 0.006}, 3, 8),
                          steel));
        // Saddle tanks behind the cabin.
        const Shell tank = smoothLathe(
            {{0.0, -0.085}, {0.030, -0.078}, {0.040, -0.050}, {0.040, 0.050}, {0.030, 0.078}, {0.0, 0.085}},
            2, 14);
        craft.add(painted(moved(turned(tank, 2, 90.0), {-0.030, 0.370, 0.070 * side}), 0xD8A020));
    }
}

} // namespace

// A light helicopter of the fifties: glass bubble, open boom, skids.
Mesh helicopter() {
    const unsigned yellow = 0xD8A020, dark = 0x3A4046;
    Assembly craft;
    // The bubble, with its frame as bands.
    const Shell bubble = turned(globe({0, 0, 0}, 0.125, 20, 28), 1, 90.0);
    craft.add(painted(moved(scaled(bubble, {1.10, 1.0, 0.95}), {0.130, 0.275, 0.0}), [](const glm::dvec3& p) {
        const bool band = std::abs(p.z) < 0.006 || std::abs(p.x - 0.135) < 0.010;
        return p.y < 0.205 ? rgb(0xD8A020) : band ? rgb(0xE8E8E4) : rgb(0x86B8CC);
    }));
    craft.add(painted(block({-0.100, 0.150, -0.085}, {0.150, 0.205, 0.085}, 0.012), yellow), 30.0);
    craft.add(painted(block({-0.085, 0.200, -0.075}, {0.025, 0.335, 0.075}, 0.015), dark), 30.0); // engine
    for (int i = 0; i < 5; ++i) // its cooling fins
        craft.add(
            painted(block({-0.096, 0.220 + 0.022 * i, -0.086}, {0.010, 0.228 + 0.022 * i, 0.086}), 0x90969C),
            30.0);
    addBoom(craft, 0x9AA0A6);
    addRotors(craft);
    addSkids(craft);
    return craft.take();
}

} // namespace limpid::models
