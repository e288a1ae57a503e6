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

// It looks along +x; z is across, y up. Sizes in its width.

constexpr unsigned metal = 0xB4B8BC, dark = 0x26282A, black = 0x101112;

// A slab seen from above (x ahead, z across), from height y0 to y1.
Shell standing(const std::vector<glm::dvec2>& polygon, double y0, double y1, double bevel) {
    // (x, −z) counter-clockwise, so that the slab's axis becomes y.
    return turned(slab(polygon, y0, y1, bevel), 0, -90.0);
}

// The rounded oblong of the body, `grown` larger on each side.
std::vector<glm::dvec2> oblong(double grown) {
    const double x = 0.115 + grown, z = 0.500 + grown;
    return rounded({{x, -z}, {x, z}, {-x, z}, {-x, -z}}, 0.100, 14);
}

// A knob with teeth around: `sides` must be four for each tooth.
Shell knurled(const std::vector<glm::dvec2>& outline, int teeth, double depth) {
    const double outer = [&] {
        double r = 0.0;
        for (const glm::dvec2& p : outline)
            r = std::max(r, p.x);
        return r;
    }();
    return shaped(lathe(outline, 4 * teeth), [=](const glm::dvec3& p) {
        const double r = std::hypot(p.x, p.z);
        if (r < 0.97 * outer) return p;
        const double wave = std::sin(teeth * std::atan2(p.z, p.x) + 0.8);
        const double scale = wave > 0.0 ? 1.0 : 1.0 - depth;
        return glm::dvec3{p.x * scale, p.y, p.z * scale};
    });
}

// From the lens's frame (its axis is y) onto the front of the body.
Shell onFront(const Shell& shell) {
    return moved(turned(shell, 2, -90.0), {0.115, -0.010, 0.0});
}

void addLens(Assembly& camera) {
    const int sides = 96;
    const auto ring = [&](const std::vector<glm::dvec2>& outline, unsigned colour) {
        camera.add(painted(onFront(lathe(outline, sides)), colour), 30.0);
    };
    ring({{0.0, -0.02}, {0.205, -0.02}, {0.205, 0.012}, {0.195, 0.020}, {0.0, 0.020}}, metal); // mount
    ring({{0.0, 0.0}, {0.178, 0.0}, {0.178, 0.055}, {0.172, 0.060}, {0.0, 0.060}}, dark);
    ring({{0.0, 0.1},
          {0.170, 0.1},
          {0.170, 0.250},
          {0.160, 0.258},
          {0.152, 0.258},
          {0.142, 0.215},
          {0.0, 0.215}},
         dark);
    // Aperture and focus: two toothed rings.
    camera.add(
        painted(
            onFront(knurled(
                {{0.0, 0.052}, {0.184, 0.056}, {0.186, 0.060}, {0.186, 0.084}, {0.184, 0.088}, {0.0, 0.092}},
                30, 0.035)),
            black),
        30.0);
    ring({{0.0, 0.086}, {0.176, 0.086}, {0.176, 0.118}, {0.0, 0.118}}, metal); // scale
    camera.add(
        painted(
            onFront(knurled(
                {{0.0, 0.116}, {0.186, 0.120}, {0.190, 0.124}, {0.190, 0.186}, {0.186, 0.190}, {0.0, 0.194}},
                54, 0.030)),
            black),
        30.0);
    ring({{0.150, 0.246}, {0.166, 0.250}, {0.166, 0.262}, {0.152, 0.262}}, 0xD0D4D8); // front rim
    // The front glass, with the coating's violet.
    const Shell glass =
        smoothLathe({{0.0, 0.190}, {0.140, 0.205}, {0.120, 0.224}, {0.070, 0.238}, {0.0, 0.243}}, 4, 56);
    camera.add(painted(onFront(glass), [](const glm::dvec3& p) {
        const double r = std::hypot(p.y + 0.010, p.z) / 0.14;
        return glm::mix(rgb(0x3A2C6C), rgb(0x0C1018), ramp(0.2, 0.9, r));
    }));
    for (int i = 0; i < 9; ++i) { // marks of the distance scale
        const double angle = -60.0 + 15.0 * i;
        const Shell mark = turned(block({0.172, 0.094, -0.003}, {0.1785, 0.110, 0.003}), 1, angle);
        camera.add(painted(onFront(mark), i == 4 ? 0xC02018 : 0xF0F0F0));
    }
}

void addBody(Assembly& camera) {
    camera.add(painted(standing(oblong(0.0), -0.290, 0.165, 0.006), metal), 30.0);
    // Leather between the plates, with its grain.
    const Shell leather = standing(oblong(0.006), -0.245, 0.120, 0.004);
    camera.add(painted(leather, dark), 30.0);
    camera.add(painted(standing(oblong(0.003), 0.150, 0.205, 0.010), metal), 30.0);
    camera.add(painted(standing(oblong(0.003), -0.300, -0.270, 0.010), metal), 30.0);
    // The prism's housing: a gable over the lens, tapering upward.
    const Shell prism = slab(
        {{-0.165, 0.190}, {0.165, 0.190}, {0.135, 0.255}, {0.070, 0.330}, {-0.070, 0.330}, {-0.135, 0.255}},
        -0.110, 0.140, 0.020);
    camera.add(painted(turned(prism, 1, 90.0), metal), 25.0);
    const Shell plate =
        slab({{-0.090, 0.215}, {0.090, 0.215}, {0.075, 0.262}, {-0.075, 0.262}}, 0.130, 0.146, 0.003);
    camera.add(painted(turned(plate, 1, 90.0), black), 25.0);
    // Eyepiece behind, accessory shoe on top.
    camera.add(painted(block({-0.150, 0.205, -0.065}, {-0.105, 0.290, 0.065}, 0.010), black), 30.0);
    camera.add(painted(block({-0.156, 0.222, -0.042}, {-0.148, 0.274, 0.042}, 0.003), 0x2C3C50), 30.0);
    camera.add(painted(block({-0.080, 0.328, -0.048}, {0.030, 0.340, 0.048}, 0.003), 0x8A8E92), 30.0);
    for (double z : {0.040, -0.048})
        camera.add(painted(block({-0.080, 0.338, z}, {0.030, 0.352, z + 0.008}, 0.002), 0x8A8E92), 30.0);
}

// What is turned and pressed on the top plate.
void addControls(Assembly& camera) {
    const auto at = [](const Shell& shell, double x, double y, double z) { return moved(shell, {x, y, z}); };
    const auto dial = [](double r, double h) {
        return std::vector<glm::dvec2>{{0.0, 0.0}, {r, 0.0}, {r, h - 0.006}, {0.9 * r, h}, {0.0, h}};
    };
    camera.add(painted(at(knurled(dial(0.072, 0.048), 36, 0.05), 0.010, 0.203, -0.275), metal),
               30.0); // shutter speeds
    camera.add(
        painted(at(lathe({{0.0, 0.0}, {0.050, 0.0}, {0.050, 0.004}, {0.0, 0.004}}, 24), 0.010, 0.250, -0.275),
                black));
    camera.add(painted(at(lathe(dial(0.060, 0.022), 28), -0.010, 0.203, -0.420), metal), 30.0);   // advance
    camera.add(painted(at(lathe(dial(0.026, 0.046), 20), 0.055, 0.203, -0.385), 0xD0D4D8), 30.0); // release
    const std::vector<glm::dvec2> lever{{-0.020, 0.400}, {0.012, 0.430},  {-0.090, 0.505},
                                        {-0.135, 0.548}, {-0.152, 0.532}, {-0.100, 0.475}};
    camera.add(painted(standing(rounded(lever, 0.02, 4), 0.222, 0.236, 0.004), dark), 30.0);
    camera.add(painted(at(knurled(dial(0.066, 0.040), 32, 0.05), -0.010, 0.203, 0.360), metal),
               30.0); // rewind
    camera.add(painted(at(lathe(dial(0.040, 0.020), 24), -0.010, 0.242, 0.360), 0xD0D4D8), 30.0);
    camera.add(painted(block({-0.018, 0.258, 0.300}, {-0.002, 0.270, 0.420}, 0.003), 0xD0D4D8),
               30.0); // its crank
    camera.add(painted(at(knurled(dial(0.020, 0.030), 8, 0.08), -0.010, 0.266, 0.412), dark), 30.0);
    // Strap lugs and their rings, self-timer, sync socket.
    for (double side : {1.0, -1.0}) {
        camera.add(painted(
            rod({{0.0, 0.110, 0.490 * side}, {0.0, 0.110, 0.530 * side}}, {0.014, 0.014}, 1, 10), metal));
        std::vector<glm::dvec2> tube;
        for (int i = 0; i < 8; ++i) {
            const double angle = glm::two_pi<double>() * i / 8;
            tube.emplace_back(0.030 + 0.005 * std::cos(angle), 0.005 * std::sin(angle));
        }
        camera.add(painted(moved(turned(lathe(tube, 20), 2, 80.0), {0.0, 0.082, 0.523 * side}), 0xD0D4D8));
    }
    const Shell timer = turned(lathe(dial(0.030, 0.020), 20), 2, -90.0);
    camera.add(painted(moved(timer, {0.118, 0.060, 0.300}), metal), 30.0);
    camera.add(painted(block({0.130, -0.060, 0.288}, {0.142, 0.060, 0.312}, 0.003), metal), 30.0);
    camera.add(painted(moved(timer, {0.118, 0.085, -0.300}), metal), 30.0);
}

} // namespace

// A single-lens reflex of the seventies.
Mesh camera() {
    Assembly camera;
    addBody(camera);
    addLens(camera);
    addControls(camera);
    return camera.take();
}

} // namespace limpid::models
