#include "FishParts.h"
#include "Models.h"
#include "Shapes.h"

#include <glm/common.hpp>
#include <glm/gtc/constants.hpp>

#include <cmath>

namespace limpid::models {

namespace {

Shell around(const Shell& shell, double degrees) {
    return turned(shell, 1, degrees);
}

// Plates: every second one of 24 a little darker, with a dark seam between rings.
glm::dvec3 plated(const glm::dvec3& p) {
    const double angle = std::atan2(p.z, p.x) / glm::two_pi<double>() + 0.5;
    const double radius = std::hypot(p.x, p.z);
    const bool second = int(std::floor(angle * 24.0)) % 2 == 1;
    const double ring = std::max(bump(0.440, 0.008, radius), bump(0.330, 0.008, radius));
    return rgb(second ? 0xA4ACB4 : 0xB8C0C8) * (1.0 - 0.5 * ring);
}

Shell saucer() {
    return painted(smoothLathe({{0.0, 0.150},
                                {0.090, 0.152},
                                {0.200, 0.165},
                                {0.330, 0.195},
                                {0.440, 0.228},
                                {0.492, 0.250},
                                {0.500, 0.262},
                                {0.488, 0.275},
                                {0.430, 0.296},
                                {0.330, 0.330},
                                {0.230, 0.362},
                                {0.190, 0.372},
                                {0.0, 0.376}},
                               4, 96),
                   plated);
}

Shell leg() {
    return rod({{0.210, 0.190, 0}, {0.300, 0.090, 0}, {0.345, 0.020, 0}}, {0.020, 0.014, 0.012}, 4, 12);
}

} // namespace

// The saucer of the films: a dome, portholes, lamps below, three legs and a ladder.
Mesh ufo() {
    Assembly ship;
    ship.add(saucer());
    ship.add(painted(
        smoothLathe(
            {{0.0, 0.360}, {0.172, 0.362}, {0.168, 0.410}, {0.140, 0.470}, {0.085, 0.512}, {0.0, 0.528}}, 5,
            48),
        0x5FB8C8)); // glass
    ship.add(painted(lathe({{0.165, 0.362}, {0.192, 0.366}, {0.190, 0.388}, {0.170, 0.392}}, 64), 0x707880),
             30.0);
    for (int i = 0; i < 8; ++i) { // ribs of the dome
        const Shell rib = rod({{0.172, 0.385, 0}, {0.143, 0.470, 0}, {0.087, 0.514, 0}, {0.004, 0.530, 0}},
                              {0.006, 0.005, 0.005, 0.004}, 4, 6);
        ship.add(painted(around(rib, 45.0 * i), 0x8A929A));
    }
    ship.add(painted(rod({{0, 0.525, 0}, {0, 0.600, 0}}, {0.006, 0.003}, 2, 8), 0x8A929A));
    ship.add(painted(globe({0, 0.606, 0}, 0.014, 8, 12), 0xE03020));

    // Portholes look up and out of the upper slope, each a lens in a ring.
    for (int i = 0; i < 16; ++i) {
        const auto placed = [&](const Shell& shell) {
            return around(moved(turned(shell, 2, -18.0), {0.385, 0.311, 0}), 22.5 * i);
        };
        ship.add(
            painted(placed(lathe({{0.020, -0.010}, {0.032, -0.010}, {0.030, 0.006}, {0.022, 0.006}}, 16)),
                    0x60686E),
            30.0);
        ship.add(painted(
            placed(smoothLathe({{0.0, -0.008}, {0.022, -0.006}, {0.014, 0.006}, {0.0, 0.009}}, 2, 14)),
            i % 2 ? 0xF8E070 : 0x60E0A0));
    }
    for (int i = 0; i < 12; ++i) { // lamps under the rim
        const Shell lamp = moved(globe({0, 0, 0}, 0.022, 8, 12), {0.400, 0.206, 0});
        ship.add(painted(around(lamp, 30.0 * i), i % 3 == 0 ? 0xF04030 : i % 3 == 1 ? 0xF8D040 : 0x40A0F0));
    }
    ship.add(painted(lathe({{0.0, 0.120}, {0.085, 0.120}, {0.115, 0.135}, {0.120, 0.165}, {0.0, 0.165}}, 48),
                     0x50585E),
             30.0); // the drive
    ship.add(
        painted(smoothLathe({{0.0, 0.100}, {0.055, 0.108}, {0.070, 0.122}, {0.0, 0.124}}, 3, 32), 0xF0F0B0),
        30.0);
    for (int i = 0; i < 3; ++i) {
        ship.add(painted(around(leg(), 60.0 + 120.0 * i), 0x70787E));
        const Shell foot =
            lathe({{0.0, 0.0}, {0.050, 0.0}, {0.046, 0.014}, {0.018, 0.030}, {0.0, 0.032}}, 24);
        ship.add(painted(around(moved(foot, {0.348, 0.0, 0}), 60.0 + 120.0 * i), 0x50585E), 30.0);
    }
    // The ladder to the hatch.
    for (double z : {0.035, -0.035})
        ship.add(painted(rod({{0.170, 0.165, z}, {0.250, 0.0, z}}, {0.006, 0.006}, 2, 6), 0x8A929A));
    for (int i = 1; i < 7; ++i) {
        const double t = i / 7.0;
        const double x = glm::mix(0.170, 0.250, t), y = glm::mix(0.165, 0.0, t);
        ship.add(painted(rod({{x, y, -0.035}, {x, y, 0.035}}, {0.004, 0.004}, 1, 6), 0x8A929A));
    }
    return ship.take();
}

} // namespace limpid::models
