#include "FishParts.h"
#include "Models.h"

#include <glm/common.hpp>

namespace limpid::models {

namespace {

const std::vector<BodyRow> trunk{
    {0.500, -0.012, -0.012, 0.000}, {0.490, 0.008, -0.030, 0.016},  {0.460, 0.034, -0.050, 0.030},
    {0.410, 0.062, -0.070, 0.043},  {0.350, 0.084, -0.088, 0.052},  {0.290, 0.099, -0.101, 0.058},
    {0.200, 0.113, -0.114, 0.062},  {0.080, 0.118, -0.118, 0.062},  {-0.050, 0.107, -0.106, 0.054},
    {-0.170, 0.083, -0.080, 0.041}, {-0.270, 0.055, -0.053, 0.027}, {-0.340, 0.042, -0.042, 0.018},
    {-0.400, 0.046, -0.046, 0.010}, {-0.430, 0.000, 0.000, 0.000}};

const Face face{{0.375, -0.006}, 0.105, {0.400, -0.042}, 0.5, -0.014};

/// What differs between the two.
struct Trout {
    double girth; ///< height of the body over the brown trout's
    double fork;  ///< how deep the tail is cut in
    Paint skin;
    unsigned fin, finEdge, iris;
    int rings, sides; ///< of the trunk
};

Shell tail(const Trout& t) {
    return fan({.root = {{-0.375, 0.040, 0.0}, {-0.385, 0.0, 0.0}, {-0.375, -0.040, 0.0}},
                .tip = {{-0.500, 0.140, 0.0},
                        {-0.510 + 0.6 * t.fork, 0.070, 0.0},
                        {-0.505 + t.fork, 0.0, 0.0},
                        {-0.510 + 0.6 * t.fork, -0.070, 0.0},
                        {-0.500, -0.140, 0.0}},
                .halfThickness = 0.010,
                .colour = finColours(t.fin, t.finEdge, 9),
                .nu = 6,
                .nv = 26});
}

Shell dorsalFin(const Trout& t) {
    const double g = t.girth;
    return fan({.root = {{0.085, 0.105 * g, 0.0}, {0.0, 0.105 * g, 0.0}, {-0.095, 0.085 * g, 0.0}},
                .tip = {{0.045, 0.205 * g, 0.0}, {-0.035, 0.200 * g, 0.0}, {-0.125, 0.140 * g, 0.0}},
                .halfThickness = 0.007,
                .colour = finColours(t.fin, t.finEdge, 8),
                .nv = 20});
}

// The small one without rays in front of the tail, by which salmon and trout are known.
Shell adiposeFin(const Trout& t) {
    return fan({.root = {{-0.245, 0.055 * t.girth, 0.0}, {-0.285, 0.040 * t.girth, 0.0}},
                .tip = {{-0.275, 0.092, 0.0}, {-0.312, 0.082, 0.0}},
                .halfThickness = 0.006,
                .colour = finColours(t.fin, t.finEdge),
                .nu = 4,
                .nv = 6});
}

Shell analFin(const Trout& t) {
    const double g = t.girth;
    return fan({.root = {{-0.160, -0.070 * g, 0.0}, {-0.200, -0.062 * g, 0.0}, {-0.250, -0.045 * g, 0.0}},
                .tip = {{-0.195, -0.150 * g, 0.0}, {-0.240, -0.135 * g, 0.0}, {-0.270, -0.085 * g, 0.0}},
                .halfThickness = 0.006,
                .colour = finColours(t.fin, t.finEdge, 6),
                .nv = 14});
}

Shell pelvicFin(const Trout& t) {
    const double g = t.girth;
    return fan(
        {.root = {{-0.010, -0.098 * g, 0.025}, {-0.040, -0.095 * g, 0.022}},
         .tip = {{-0.055, -0.155 * g, 0.055}, {-0.090, -0.145 * g, 0.048}, {-0.100, -0.112 * g, 0.035}},
         .halfThickness = 0.006,
         .colour = finColours(t.fin, t.finEdge, 5),
         .nv = 10});
}

Shell pectoralFin(const Trout& t) {
    return fan({.root = {{0.270, -0.068, 0.045}, {0.255, -0.086, 0.040}},
                .tip = {{0.155, -0.085, 0.120}, {0.145, -0.115, 0.110}, {0.185, -0.125, 0.075}},
                .halfThickness = 0.006,
                .colour = finColours(t.fin, t.finEdge, 6),
                .nv = 12});
}

Mesh swimmer(const Trout& t) {
    Assembly fish{swimming(0.1, 0.075)};
    const Shell round = evenBody(trunk, t.rings, t.sides);
    fish.add(scaled(withFace(painted(round, t.skin), face), {1.0, t.girth, 1.0}));
    for (const Shell& part : {tail(t), dorsalFin(t), adiposeFin(t), analFin(t)})
        fish.add(part);
    for (const Shell& part : {pelvicFin(t), pectoralFin(t), eye({0.425, 0.020, 0.030}, 0.017, t.iris)})
        fish.addPair(part);
    return fish.take();
}

// From belly over flank to back by height within the body.
glm::dvec3 shaded(double y, unsigned belly, unsigned flank, unsigned back) {
    const glm::dvec3 low = glm::mix(rgb(belly), rgb(flank), ramp(-0.095, -0.030, y));
    return glm::mix(low, rgb(back), ramp(-0.005, 0.080, y));
}

} // namespace

Mesh brownTrout() {
    const Paint skin = [](const glm::dvec3& p) {
        glm::dvec3 colour = shaded(p.y, 0xF0DFA8, 0xC89A45, 0x54441C);
        const double spot = flankScatter(p, 0.066);
        const bool red = p.y < 0.015 && noise(p, 0.055) > 0.5;
        if (p.y > -0.055 && p.x < 0.44) {
            colour = glm::mix(colour, rgb(0xE8CE8A), 0.5 * (1.0 - ramp(0.30, 0.46, spot)));
            colour = glm::mix(colour, red ? rgb(0xB02010) : rgb(0x1C1408), 1.0 - ramp(0.15, 0.30, spot));
        }
        return colour;
    };
    return swimmer({1.0, 0.012, skin, 0xB08A48, 0x8C6428, 0xC09030, 76, 28});
}

Mesh steelHead() {
    const Paint skin = [](const glm::dvec3& p) {
        glm::dvec3 colour = shaded(p.y, 0xF4F4F0, 0xC8CED2, 0x33505E);
        colour =
            glm::mix(colour, rgb(0xD8808A), 0.75 * bump(0.004, 0.040, p.y) * (1.0 - ramp(0.40, 0.48, p.x)));
        const double spot = flankScatter(p, 0.040);
        if (p.y > 0.025) colour = glm::mix(colour, rgb(0x101418), 0.9 * (1.0 - ramp(0.22, 0.36, spot)));
        return colour;
    };
    return swimmer({0.80, 0.045, skin, 0x9AA6A8, 0x6E8086, 0xD8C890, 84, 28});
}

} // namespace limpid::models
