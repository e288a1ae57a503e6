#include "FishParts.h"
#include "Models.h"
#include "Shapes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace limpid::models {

namespace {

// A slab that lies: the polygon (x forward, y to the left) from height y0 to y1.
Shell lying(const std::vector<glm::dvec2>& polygon, double y0, double y1, double bevel = 0.0) {
    return turned(slab(polygon, y0, y1, bevel), 0, -90.0);
}

// A back slat, bowed backwards: a strip between two arcs.
Shell slat(double x, double y0, double y1) {
    const double h = 0.185, bow = 0.045, thick = 0.022;
    return lying({{x, h}, {x - bow, 0.0}, {x, -h}, {x + thick, -h}, {x + thick - bow, 0.0}, {x + thick, h}},
                 y0, y1);
}

} // namespace

// Ladder-backed, in the fewest triangles that say so.
Mesh chair() {
    const unsigned wood = 0x8A5428;
    Assembly chair;
    const auto add = [&](const Shell& shell, unsigned colour) { chair.add(painted(shell, colour), 20.0); };
    for (double z : {0.200, -0.200}) {
        // Front leg, tapered; hind leg, which leans back above the seat.
        add(slab({{0.172, 0.0}, {0.200, 0.0}, {0.210, 0.450}, {0.165, 0.450}}, z - 0.020, z + 0.020), wood);
        add(slab({{-0.250, 0.0},
                  {-0.222, 0.0},
                  {-0.180, 0.450},
                  {-0.258, 1.0},
                  {-0.285, 1.0},
                  {-0.225, 0.450}},
                 z - 0.020, z + 0.020),
            wood);
        add(block({-0.220, 0.170, z - 0.012}, {0.190, 0.195, z + 0.012}), wood); // stretcher
    }
    add(block({0.176, 0.250, -0.195}, {0.198, 0.280, 0.195}), wood);
    add(lying({{0.245, -0.215},
               {0.245, 0.215},
               {0.225, 0.235},
               {-0.200, 0.205},
               {-0.215, 0.185},
               {-0.215, -0.185},
               {-0.200, -0.205},
               {0.225, -0.235}},
              0.440, 0.475),
        0xB98B4E); // the seat, of straw
    for (double y : {0.590, 0.740, 0.890})
        add(slat(-0.165 - 0.142 * (y - 0.450) - 0.035, y, y + 0.075), wood);
    return chair.take();
}

// A washbasin on its pedestal, with a mixer tap.
Mesh sink() {
    const unsigned china = 0xEEEEE8, chrome = 0xA8B0B6;
    Assembly sink;
    const Shell bowl = lathe({{0.0, 0.640},
                              {0.110, 0.650},
                              {0.200, 0.720},
                              {0.255, 0.800},
                              {0.280, 0.830},
                              {0.285, 0.855},
                              {0.270, 0.865},
                              {0.240, 0.855},
                              {0.220, 0.800},
                              {0.165, 0.735},
                              {0.080, 0.705},
                              {0.0, 0.700}},
                             20);
    sink.add(painted(scaled(bowl, {0.90, 1.0, 1.20}), china), 50.0);
    // The ledge that carries the tap and goes to the wall.
    const std::vector<glm::dvec2> ledge{{-0.130, -0.300}, {-0.130, 0.300},  {-0.180, 0.330},
                                        {-0.330, 0.330},  {-0.330, -0.330}, {-0.180, -0.330}};
    sink.add(painted(lying(ledge, 0.790, 0.880, 0.012), china), 30.0);
    const Shell foot = lathe({{0.0, 0.0},
                              {0.150, 0.0},
                              {0.152, 0.035},
                              {0.105, 0.090},
                              {0.085, 0.350},
                              {0.105, 0.600},
                              {0.150, 0.700},
                              {0.0, 0.700}},
                             16);
    sink.add(painted(moved(foot, {-0.060, 0.0, 0.0}), china), 50.0);
    sink.add(painted(lathe({{0.0, 0.700}, {0.030, 0.700}, {0.026, 0.710}, {0.0, 0.708}}, 10), chrome));
    sink.add(painted(rod({{-0.235, 0.870, 0},
                          {-0.235, 0.970, 0},
                          {-0.200, 1.010, 0},
                          {-0.120, 1.000, 0},
                          {-0.085, 0.950, 0}},
                         {0.022, 0.018, 0.016, 0.016, 0.017}, 2, 8),
                     chrome),
             60.0);
    for (double z : {0.120, -0.120}) {
        const Shell knob = lathe(
            {{0.0, 0.875}, {0.026, 0.875}, {0.016, 0.905}, {0.034, 0.925}, {0.030, 0.955}, {0.0, 0.962}}, 8);
        sink.add(painted(moved(knob, {-0.235, 0.0, z}), chrome), 30.0);
    }
    return sink.take();
}

namespace {

// A cushion with seams: it bulges in the middle and is drawn in where buttons are.
Shell padded(const glm::dvec3& centre, const glm::dvec3& half, int steps, unsigned colour) {
    const Shell pad = cushion(centre, half, 5.0, steps);
    return painted(pad, [=](const glm::dvec3& p) {
        const glm::dvec3 q = glm::abs(p - centre) / half;
        const double seam = bump(0.0, 0.12, std::min({std::abs(q.y - 0.80), 1.0}));
        return rgb(colour) * (1.0 - 0.22 * seam) * (0.95 + 0.10 * noise(p, 0.02));
    });
}

// The arm on the side of −z; its roll leans out.
Shell arm(double z, unsigned colour) {
    std::vector<glm::dvec2> outline{{0.045, 0.060}, {0.045, 0.260}};
    for (int i = 0; i <= 16; ++i) {
        const double angle = glm::radians(-35.0 + 250.0 * i / 16.0);
        outline.emplace_back(0.012 + 0.062 * std::cos(angle), 0.300 + 0.055 * std::sin(angle));
    }
    outline.emplace_back(-0.045, 0.255);
    outline.emplace_back(-0.045, 0.060);
    const Shell shell = turned(slab(outline, -0.210, 0.200, 0.012), 1, 90.0);
    return painted(moved(shell, {0.0, 0.0, z}), colour);
}

} // namespace

Mesh sofa() {
    const unsigned cloth = 0x8E2F2A, dark = 0x6E2420, wood = 0x3A2416;
    Assembly sofa;
    sofa.add(painted(block({-0.190, 0.060, -0.420}, {0.185, 0.160, 0.420}, 0.015), dark), 30.0);
    for (double z : {0.205, -0.205}) {
        sofa.add(padded({0.030, 0.205, z}, {0.185, 0.058, 0.203}, 12, cloth), 60.0);
        Shell back = padded({0.0, 0.0, 0.0}, {0.060, 0.130, 0.200}, 12, cloth);
        sofa.add(moved(turned(back, 2, 14.0), {-0.140, 0.360, z}), 60.0);
    }
    // The back's frame, rolled over at its top.
    std::vector<glm::dvec2> frame{{-0.240, 0.060}, {-0.160, 0.060}, {-0.185, 0.420}};
    for (int i = 0; i <= 10; ++i) {
        const double angle = glm::radians(10.0 + 200.0 * i / 10.0);
        frame.emplace_back(-0.235 + 0.046 * std::cos(angle), 0.455 + 0.036 * std::sin(angle));
    }
    frame.emplace_back(-0.262, 0.400);
    sofa.add(painted(slab(frame, -0.430, 0.430, 0.012), dark), 40.0);
    for (double side : {1.0, -1.0}) {
        const Shell one = arm(-0.455, cloth);
        sofa.add(side > 0.0 ? one : mirroredInZ(one), 40.0);
    }
    for (double x : {0.160, -0.200})
        for (double z : {0.430, -0.430}) {
            const Shell foot = lathe(
                {{0.0, 0.0}, {0.018, 0.0}, {0.022, 0.012}, {0.030, 0.045}, {0.024, 0.065}, {0.0, 0.065}}, 14);
            sofa.add(painted(moved(foot, {x, 0.0, z}), wood));
        }
    // Two small pillows, thrown into the corners.
    for (double side : {1.0, -1.0}) {
        const Shell pillow = painted(swollen(cushion({0, 0, 0}, {0.045, 0.095, 0.095}, 2.6, 9),
                                             [](const glm::dvec3& p) {
                                                 const double edge =
                                                     std::max(std::abs(p.y), std::abs(p.z)) / 0.095;
                                                 return -0.010 * ramp(0.7, 1.0, edge);
                                             }),
                                     side > 0.0 ? 0xE0C070 : 0xD8D0B8);
        sofa.add(moved(turned(turned(turned(pillow, 0, 40.0), 2, 24.0), 1, 18.0 * side),
                       {-0.020, 0.345, 0.300 * side}));
    }
    return sofa.take();
}

} // namespace limpid::models
