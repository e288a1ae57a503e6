#include "FishParts.h"
#include "Models.h"
#include "Shapes.h"

#include <glm/common.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace limpid::models {

namespace {

// Grooves along throat and belly, one at each `spacing` across.
double pleats(const glm::dvec3& p) {
    const double low = 1.0 - ramp(-0.060, -0.030, p.y + 0.25 * std::abs(p.x - 0.25));
    const double groove = 0.5 - 0.5 * std::cos(glm::two_pi<double>() * p.z / 0.026);
    return low * ramp(-0.06, 0.02, p.x) * (1.0 - ramp(0.42, 0.46, p.x)) * groove;
}

Shell whaleTrunk() {
    const Paint skin = [](const glm::dvec3& p) {
        const double ragged = 0.020 * noise(p, 0.05);
        const glm::dvec3 two =
            glm::mix(rgb(0xD9DDDD), rgb(0x25303A), ramp(-0.095, -0.070, p.y + ragged - 0.02));
        const double lip = bump(0.006 - 0.09 * ramp(0.36, 0.24, p.x), 0.012, p.y) * ramp(0.22, 0.25, p.x);
        return two * (1.0 - 0.55 * pleats(p)) * (1.0 - 0.6 * lip);
    };
    Shell trunk = painted(evenBody({{0.480, -0.010, -0.010, 0.000},
                                    {0.470, 0.012, -0.040, 0.036},
                                    {0.430, 0.032, -0.078, 0.062},
                                    {0.360, 0.054, -0.112, 0.084},
                                    {0.260, 0.086, -0.134, 0.104},
                                    {0.140, 0.112, -0.132, 0.112},
                                    {0.010, 0.116, -0.110, 0.104},
                                    {-0.120, 0.100, -0.072, 0.082},
                                    {-0.240, 0.062, -0.036, 0.052},
                                    {-0.340, 0.026, -0.022, 0.028},
                                    {-0.410, 0.006, -0.020, 0.014},
                                    {-0.450, -0.006, -0.006, 0.000}},
                                   58, 34),
                          skin);
    return swollen(std::move(trunk), [](const glm::dvec3& p) { return -0.006 * pleats(p); });
}

// Knobs on head and jaw, each the root of a hair.
void addKnobs(Assembly& whale) {
    for (int i = 0; i < 6; ++i) {
        const double x = 0.455 - 0.030 * i;
        whale.addPair(painted(globe({x, 0.024 + 0.10 * (0.455 - x), 0.030 + 0.13 * (0.455 - x)}, 0.008, 5, 7),
                              0x38444E));
    }
}

// The arch of a dive: head and tail hang.
glm::dvec3 diving(const glm::dvec3& p) {
    const double rear = std::min(p.x + 0.05, 0.0), front = std::max(p.x - 0.15, 0.0);
    return {p.x, p.y - 0.75 * rear * rear - 0.35 * front * front, p.z};
}

} // namespace

// A humpback: flippers a third of its length, grooved below, flukes with a ragged edge.
Mesh whale() {
    Assembly whale{diving};
    whale.add(whaleTrunk());
    addKnobs(whale);
    whale.add(fan({.root = {{-0.400, -0.006, -0.012}, {-0.400, -0.006, 0.012}},
                   .tip = {{-0.520, -0.010, -0.200},
                           {-0.505, -0.006, -0.110},
                           {-0.485, -0.006, -0.040},
                           {-0.462, -0.006, 0.000},
                           {-0.485, -0.006, 0.040},
                           {-0.505, -0.006, 0.110},
                           {-0.520, -0.010, 0.200}},
                   .halfThickness = 0.014,
                   .spines = 12,
                   .jag = 0.05,
                   .colour = finColours(0x25303A, 0x1C262E),
                   .nu = 8,
                   .nv = 26}));
    whale.add(fan({.root = {{-0.080, 0.095, 0}, {-0.130, 0.090, 0}, {-0.190, 0.072, 0}},
                   .tip = {{-0.140, 0.140, 0}, {-0.165, 0.142, 0}, {-0.205, 0.085, 0}},
                   .halfThickness = 0.014,
                   .colour = finColours(0x25303A, 0x25303A),
                   .nu = 4,
                   .nv = 8}));
    whale.addPair(fan({.root = {{0.235, -0.055, 0.085}, {0.160, -0.060, 0.090}},
                       .tip = {{0.080, -0.150, 0.360}, {0.045, -0.150, 0.370}, {0.030, -0.140, 0.340}},
                       .halfThickness = 0.016,
                       .spines = 5,
                       .jag = 0.05,
                       .colour = finColours(0x3A464E, 0xE4E8E8),
                       .nu = 10,
                       .nv = 12}));
    whale.addPair(eye({0.262, -0.050, 0.092}, 0.010, 0x303030));
    return whale.take();
}

namespace {

// The manta's wings: s from −1 (one tip) to 1, the beat of the wings as height by z.
double beat(double z) {
    return 0.62 * z * z - 0.45 * z * z * z * z;
}

Shell mantaWings() {
    const auto edge = [](double s, bool front) {
        const double a = std::abs(s);
        return front ? 0.235 - 0.10 * a - 0.34 * a * a : -0.205 + 0.27 * a * std::exp(-2.2 * a) - 0.03 * a;
    };
    const Shell wings = sheet(
        {.middle =
             [&](double u, double v) {
                 const double s = std::sin(glm::half_pi<double>() * (2.0 * v - 1.0));
                 const double chord = u * u * (3.0 - 2.0 * u);
                 return glm::dvec3{glm::mix(edge(s, true), edge(s, false), chord), beat(0.5 * s), -0.5 * s};
             },
         .half =
             [](double u, double v) {
                 const double s = std::sin(glm::half_pi<double>() * (2.0 * v - 1.0));
                 const double chord = u * u * (3.0 - 2.0 * u);
                 const double back = 0.066 * std::exp(-s * s / 0.045) + 0.016 * (1.0 - s * s);
                 return 0.003 + back * 2.2 * std::sqrt(chord) * (1.0 - chord);
             },
         .colour = {},
         .nu = 28,
         .nv = 46});
    return painted(wings, [](const glm::dvec3& p) {
        const double z = std::abs(p.z);
        const bool above = p.y > beat(p.z) - 1e-9;
        const double shoulder = bump(0.105 - 0.25 * (z - 0.12), 0.045, p.x) * bump(0.13, 0.075, z);
        double slits = 0.0;
        for (int i = 0; i < 5; ++i)
            slits = std::max(slits, bump(0.085 - 0.032 * i, 0.013, p.x) * bump(0.075, 0.045, z));
        const glm::dvec3 back = glm::mix(rgb(0x1B2128), rgb(0xE6E8E6), ramp(0.2, 0.6, shoulder));
        const glm::dvec3 belly = glm::mix(rgb(0xECEEEC), rgb(0x4A5058), ramp(0.38, 0.49, z));
        return above ? back : belly * (1.0 - 0.8 * slits);
    });
}

} // namespace

Mesh manta() {
    Assembly ray;
    ray.add(mantaWings());
    // The mouth, a wide slot between the horns, and the horns themselves.
    ray.add(painted(cushion({0.215, 0.000, 0.0}, {0.030, 0.018, 0.080}, 4.0, 6), 0x30343A));
    ray.addPair(fan({.root = {{0.215, 0.020, 0.086}, {0.225, 0.000, 0.098}, {0.205, -0.020, 0.090}},
                     .tip = {{0.350, -0.025, 0.062}, {0.348, -0.040, 0.066}, {0.335, -0.048, 0.060}},
                     .halfThickness = 0.012,
                     .colour = finColours(0x1B2128, 0x2A3038),
                     .nu = 8,
                     .nv = 8}));
    ray.addPair(eye({0.180, 0.006, 0.112}, 0.014, 0x202428));
    ray.add(fan({.root = {{-0.150, 0.015, 0}, {-0.200, 0.006, 0}},
                 .tip = {{-0.205, 0.060, 0}, {-0.235, 0.040, 0}},
                 .colour = finColours(0x1B2128, 0x1B2128),
                 .nu = 4,
                 .nv = 6}));
    ray.add(painted(
        rod({{-0.170, 0.000, 0}, {-0.300, -0.006, 0.01}, {-0.450, 0.010, -0.03}, {-0.600, 0.030, 0.02}},
            {0.016, 0.009, 0.006, 0.002}, 6, 8),
        0x1B2128));
    return ray.take();
}

// The ocean sunfish, half a fish: a disc with two blades and a frilled seam for a tail.
Mesh sunFish() {
    const Paint skin = [](const glm::dvec3& p) {
        const glm::dvec3 colour = glm::mix(rgb(0xCFD4D4), rgb(0x66727C), ramp(-0.15, 0.25, p.y));
        return colour * (0.75 + 0.45 * noise(p, 0.045));
    };
    Assembly fish{swimming(0.0, 0.03)};
    const Shell disc = evenBody({{0.400, 0.020, 0.020, 0.000},
                                 {0.392, 0.050, -0.010, 0.020},
                                 {0.365, 0.108, -0.062, 0.042},
                                 {0.315, 0.172, -0.134, 0.064},
                                 {0.230, 0.226, -0.200, 0.084},
                                 {0.120, 0.256, -0.240, 0.094},
                                 {0.000, 0.266, -0.256, 0.090},
                                 {-0.110, 0.258, -0.252, 0.070},
                                 {-0.200, 0.232, -0.230, 0.044},
                                 {-0.255, 0.190, -0.190, 0.024},
                                 {-0.290, 0.000, 0.000, 0.000}},
                                40, 32);
    fish.add(withFace(painted(disc, skin), {{1.0, 0.0}, 0.01, {0.375, 0.016}, 0.4, 0.020}));
    for (double sign : {1.0, -1.0})
        fish.add(
            fan({.root = {{-0.050, 0.235 * sign, 0}, {-0.140, 0.225 * sign, 0}, {-0.225, 0.185 * sign, 0}},
                 .tip = {{-0.200, 0.500 * sign, 0}, {-0.240, 0.530 * sign, 0}, {-0.262, 0.430 * sign, 0}},
                 .halfThickness = 0.016,
                 .colour = finColours(0x66727C, 0x4A545C, 3),
                 .nu = 9,
                 .nv = 10}));
    // Eight lobes behind, as wide as the disc is high.
    fish.add(fan({.root = {{-0.210, 0.185, 0},
                           {-0.250, 0.100, 0},
                           {-0.262, 0, 0},
                           {-0.250, -0.100, 0},
                           {-0.210, -0.200, 0}},
                  .tip = {{-0.275, 0.215, 0},
                          {-0.335, 0.105, 0},
                          {-0.355, 0, 0},
                          {-0.335, -0.105, 0},
                          {-0.275, -0.215, 0}},
                  .halfThickness = 0.016,
                  .spines = 8,
                  .jag = 0.25,
                  .colour = finColours(0x77838B, 0x505A62, 8),
                  .nu = 5,
                  .nv = 32}));
    fish.addPair(fan({.root = {{0.110, 0.000, 0.088}, {0.095, -0.045, 0.088}},
                      .tip = {{0.010, 0.050, 0.130}, {-0.015, -0.010, 0.135}, {0.015, -0.060, 0.125}},
                      .colour = finColours(0x808C94, 0x606A72, 5),
                      .nu = 4,
                      .nv = 10}));
    fish.addPair(eye({0.305, 0.055, 0.054}, 0.020, 0xB0A878));
    // Lips like a beak.
    fish.add(painted(cushion({0.398, 0.018, 0.0}, {0.016, 0.020, 0.015}, 2.5, 6), 0xD8DCDC));
    return fish.take();
}

} // namespace limpid::models
