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

double roundedMax(double a, double b, double k) {
    const double h = std::max(k - std::abs(a - b), 0.0) / k;
    return std::max(a, b) + 0.25 * k * h * h;
}

// A rod along x from x0 to x1 with a chamfered rim.
Field bar(double x0, double x1, double radius) {
    return [=](const glm::dvec3& p) {
        const double side = glm::length(glm::dvec2{p.y, p.z}) - radius;
        return roundedMax(side, std::max(x0 - p.x, p.x - x1), 0.012);
    };
}

// The claw bends down as it goes back, gets wider and thinner, and is split by a wedge.
double claw(const glm::dvec3& p) {
    const double back = std::clamp((-0.020 - p.x) / 0.190, 0.0, 1.0);
    const double y = p.y + 0.115 * back * back - 0.006;
    const double thickness = glm::mix(0.034, 0.005, std::pow(back, 0.8));
    const double width = glm::mix(0.036, 0.056, back);
    const double plate = roundedMax(std::abs(y) - thickness, std::abs(p.z) - width, 0.012);
    const double ends = std::max(-0.205 - p.x, p.x - 0.010);
    const double slot = 0.018 * ramp(-0.070, -0.200, p.x) + 0.004 - std::abs(p.z);
    const double split = p.x < -0.060 ? slot : -0.1;
    return 0.8 * roundedMax(roundedMax(plate, ends, 0.008), split, 0.006);
}

double cheek(const glm::dvec3& p) {
    const glm::dvec3 q = glm::abs(p - glm::dvec3{0.0, 0.0, 0.0}) - glm::dvec3{0.034, 0.046, 0.038} + 0.012;
    return glm::length(glm::max(q, 0.0)) + std::min(std::max({q.x, q.y, q.z}), 0.0) - 0.012;
}

Shell head() {
    const Field neck = joined({bar(0.010, 0.130, 0.034), cheek}, 0.030);
    const Field poll = joined({neck, bar(0.105, 0.175, 0.052)}, 0.022);
    return surfaceOf(joined({poll, claw}, 0.018), {-0.23, -0.16, -0.075}, {0.20, 0.075, 0.075}, 0.0045, 7400);
}

// Ash, thicker in the hand, swollen at the end; its height is along −y.
Shell handle() {
    const std::vector<BodyRow> rows{
        {0.052, 0.000, 0.000, 0.000},   {0.050, 0.022, -0.022, 0.020},  {-0.060, 0.026, -0.026, 0.022},
        {-0.200, 0.024, -0.024, 0.018}, {-0.380, 0.025, -0.025, 0.018}, {-0.560, 0.034, -0.034, 0.025},
        {-0.720, 0.036, -0.036, 0.026}, {-0.840, 0.032, -0.032, 0.024}, {-0.910, 0.042, -0.042, 0.029},
        {-0.935, 0.040, -0.040, 0.027}, {-0.945, 0.000, 0.000, 0.000}};
    const Shell lying = painted(evenBody(rows, 76, 36), [](const glm::dvec3& p) {
        const double grain = noise({3.0 * p.x, 40.0 * p.y, 40.0 * p.z}, 0.7);
        return glm::mix(rgb(0xC89858), rgb(0xA06A30), grain);
    });
    return turned(lying, 2, 90.0);
}

} // namespace

// Leaning on nothing: it hangs upright, head up, as a hand would hold it.
Mesh hammer() {
    Assembly tool;
    const Paint steel = [](const glm::dvec3& p) {
        const glm::dvec3 forged = glm::mix(rgb(0x3C4248), rgb(0x50565C), noise(p, 0.02));
        const double bright = std::max(ramp(0.160, 0.170, p.x), ramp(-0.12, -0.17, p.x));
        return glm::mix(forged, rgb(0xB8BEC4), bright);
    };
    tool.add(painted(head(), steel), 45.0);
    tool.add(handle());
    tool.add(
        painted(block({-0.016, 0.045, -0.003}, {0.016, 0.054, 0.003}), 0x8A8E92)); // the wedge in the eye
    return tool.take();
}

} // namespace limpid::models
