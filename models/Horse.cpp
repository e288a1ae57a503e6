#include "Field.h"
#include "FishParts.h"
#include "Models.h"
#include "Shapes.h"

#include <glm/common.hpp>

namespace limpid::models {

namespace {

// Sizes in about the length from chest to rump and half as much again; the withers stand 0.8 high.

/// The joints of a leg from the body down to the hoof's top, and the radii there.
struct Leg {
    std::vector<glm::dvec3> joints;
    std::vector<double> radii;
    double hoofTurn; ///< degrees, toe up
};

const std::vector<double> foreRadii{0.078, 0.052, 0.031, 0.022, 0.025, 0.027};
const std::vector<double> hindRadii{0.112, 0.074, 0.034, 0.024, 0.026, 0.028};

std::vector<Leg> walkingLegs() {
    return {{{{0.190, 0.560, 0.070},
              {0.190, 0.440, 0.080},
              {0.225, 0.262, 0.074},
              {0.245, 0.120, 0.072},
              {0.248, 0.088, 0.072},
              {0.268, 0.045, 0.072}},
             foreRadii,
             0.0},
            // lifted
            {{{0.190, 0.560, -0.070},
              {0.200, 0.440, -0.080},
              {0.300, 0.320, -0.074},
              {0.235, 0.200, -0.072},
              {0.222, 0.172, -0.072},
              {0.205, 0.132, -0.072}},
             foreRadii,
             -75.0},
            {{{-0.250, 0.610, 0.065},
              {-0.200, 0.460, 0.085},
              {-0.345, 0.290, 0.078},
              {-0.350, 0.125, 0.074},
              {-0.348, 0.092, 0.074},
              {-0.328, 0.045, 0.074}},
             hindRadii,
             0.0},
            {{{-0.250, 0.610, -0.065},
              {-0.180, 0.460, -0.085},
              {-0.285, 0.285, -0.078},
              {-0.240, 0.125, -0.074},
              {-0.234, 0.092, -0.074},
              {-0.212, 0.045, -0.074}},
             hindRadii,
             0.0}};
}

Field limbs() {
    std::vector<Field> parts;
    for (const Leg& leg : walkingLegs()) {
        std::vector<Field> bones;
        for (std::size_t i = 0; i + 1 < leg.joints.size(); ++i)
            bones.push_back(roundCone(leg.joints[i], leg.radii[i], leg.joints[i + 1], leg.radii[i + 1]));
        bones.push_back(roundCone(leg.joints[2], leg.radii[2] * 1.1, leg.joints[2] + 0.01, leg.radii[2]));
        parts.push_back(joined(bones, 0.020));
    }
    return joined(parts, 0.010);
}

Field neckAndHead() {
    const Field neck = joined({roundCone({0.225, 0.650, 0}, 0.135, {0.370, 0.865, 0}, 0.085),
                               roundCone({0.370, 0.865, 0}, 0.085, {0.425, 0.965, 0}, 0.062)},
                              0.06);
    const Field head = joined({roundCone({0.440, 0.965, 0}, 0.060, {0.500, 0.900, 0}, 0.056),
                               roundCone({0.490, 0.915, 0}, 0.054, {0.610, 0.790, 0}, 0.036),
                               roundCone({0.455, 0.920, 0}, 0.058, {0.520, 0.845, 0}, 0.040),
                               ellipsoid({0.620, 0.775, 0}, {0.042, 0.040, 0.042})},
                              0.030);
    const Field flat = [=, parts = joined({neck, head}, 0.035)](const glm::dvec3& p) {
        return parts({p.x, p.y, p.z * 1.30}) / 1.30;
    };
    const Field ears = joined({roundCone({0.415, 1.010, 0.030}, 0.020, {0.425, 1.085, 0.036}, 0.005),
                               roundCone({0.415, 1.010, -0.030}, 0.020, {0.425, 1.085, -0.036}, 0.005)},
                              0.010);
    return joined({flat, ears}, 0.015);
}

Field solid() {
    const Field trunk = joined({ellipsoid({-0.020, 0.615, 0}, {0.330, 0.160, 0.138}),
                                ellipsoid({0.180, 0.610, 0}, {0.150, 0.165, 0.115}),
                                ellipsoid({-0.255, 0.655, 0}, {0.160, 0.150, 0.132}),
                                roundCone({0.150, 0.730, 0}, 0.070, {0.000, 0.705, 0}, 0.070)},
                               0.06);
    return joined({joined({trunk, neckAndHead()}, 0.07), limbs()}, 0.035);
}

glm::dvec3 bay(const glm::dvec3& p) {
    const glm::dvec3 coat = glm::mix(rgb(0x8A4A22), rgb(0x6A3414), ramp(0.45, 0.80, p.y));
    const double stocking = 1.0 - ramp(0.22, 0.36, p.y);
    const double muzzle = ramp(0.585, 0.625, p.x - 0.3 * (p.y - 0.79));
    const double blaze =
        bump(0.0, 0.022, p.z) * ramp(0.50, 0.53, p.x) * ramp(0.80, 0.84, p.y + 0.3 * (p.x - 0.55));
    return glm::mix(glm::mix(coat, rgb(0x1E1410), glm::max(stocking, 0.8 * muzzle)), rgb(0xE8E0D4), blaze);
}

Shell hoof(const Leg& leg) {
    const Shell shell = lathe({{0.0, -0.045}, {0.040, -0.045}, {0.028, 0.004}, {0.0, 0.004}}, 10);
    return painted(moved(turned(shell, 2, leg.hoofTurn), leg.joints.back()), 0x1A1614);
}

} // namespace

Mesh horse() {
    Assembly animal;
    animal.add(painted(surfaceOf(solid(), {-0.45, 0.0, -0.2}, {0.70, 1.12, 0.2}, 0.011, 3400), bay), 60.0);
    for (const Leg& leg : walkingLegs())
        animal.add(hoof(leg));
    // Mane and forelock fall to one side.
    const auto hair = finColours(0x1A120E, 0x2A1C14, 14);
    animal.add(fan({.root = {{0.430, 1.000, 0.0},
                             {0.360, 0.935, 0.0},
                             {0.285, 0.850, 0.0},
                             {0.200, 0.775, 0.0},
                             {0.120, 0.760, 0.0}},
                    .tip = {{0.405, 1.070, 0.010},
                            {0.305, 0.985, 0.034},
                            {0.222, 0.900, 0.044},
                            {0.150, 0.840, 0.040},
                            {0.090, 0.810, 0.020}},
                    .halfThickness = 0.022,
                    .ripple = 0.008,
                    .waves = 5.0,
                    .spines = 7,
                    .jag = 0.22,
                    .colour = hair,
                    .nu = 5,
                    .nv = 21}));
    animal.add(fan({.root = {{0.445, 1.020, -0.020}, {0.445, 1.020, 0.025}},
                    .tip = {{0.520, 0.935, -0.008}, {0.525, 0.930, 0.012}},
                    .halfThickness = 0.012,
                    .colour = hair,
                    .nu = 4,
                    .nv = 4}));
    animal.add(painted(rod({{-0.385, 0.730, 0},
                            {-0.450, 0.715, 0.005},
                            {-0.490, 0.600, 0.010},
                            {-0.495, 0.430, 0.020},
                            {-0.470, 0.270, 0.030}},
                           {0.026, 0.034, 0.044, 0.050, 0.008}, 4, 10),
                       0x1A120E));
    animal.addPair(painted(globe({0.498, 0.938, 0.036}, 0.014, 6, 8), 0x0C0806));
    for (double sign : {1.0, -1.0}) // nostrils
        animal.add(painted(globe({0.640, 0.782, 0.022 * sign}, 0.010, 4, 6), 0x0C0806));
    return animal.take();
}

} // namespace limpid::models
