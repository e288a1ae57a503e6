#include "FishParts.h"
#include "Models.h"
#include "Shapes.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace limpid::models {

namespace {

/// A fin in the plane z = 0 or one of a pair: its root and tip as Fan has them.
struct FinShape {
    std::vector<glm::dvec3> root, tip;
    bool paired = false;
};

struct Shark {
    std::vector<BodyRow> trunk;
    int rings, sides;
    std::vector<FinShape> fins;
    glm::ivec2 finCells; ///< of the largest fin, the first one
    Paint skin;
    Paint finSkin;
    glm::dvec3 eye; ///< where one of them is
    double eyeRadius;
    double gills; ///< x of the foremost of the five slits
    glm::dvec2 mouth;
    double noseY;
    double bend;
};

// Five slits, darkened and pressed in.
double slits(const Shark& shark, const glm::dvec3& p) {
    double deepest = 0.0;
    for (int i = 0; i < 5; ++i)
        deepest = std::max(deepest, bump(shark.gills - 0.022 * i + 0.12 * p.y, 0.010, p.x));
    const double middle = shark.mouth.y + 0.035;
    return deepest * bump(middle, 0.050, p.y);
}

// The skin of the flank, and of the belly for fins that hang.
Paint likeFlank(const Paint& skin) {
    return [skin](const glm::dvec3& p) { return skin({p.x, std::clamp(p.y, -0.02, 0.09), p.z}); };
}

Mesh swimmer(const Shark& shark) {
    Assembly fish{swimming(0.15, shark.bend)};
    Shell round = painted(evenBody(shark.trunk, shark.rings, shark.sides), [&](const glm::dvec3& p) {
        return shark.skin(p) * (1.0 - 0.75 * slits(shark, p));
    });
    round = swollen(std::move(round), [&](const glm::dvec3& p) { return -0.004 * slits(shark, p); });
    fish.add(withFace(std::move(round),
                      {{1.0, 0.0}, 0.01, shark.mouth, shark.trunk.front().x - 0.055, shark.noseY}));
    for (const FinShape& shape : shark.fins) {
        const bool first = &shape == &shark.fins.front();
        const Shell part = fan({.root = shape.root,
                                .tip = shape.tip,
                                .halfThickness = 0.010,
                                .colour = {},
                                .nu = first ? shark.finCells.x : std::max(2, shark.finCells.x - 2),
                                .nv = first ? shark.finCells.y : shark.finCells.y / 2});
        const Shell coloured = painted(part, shark.finSkin);
        if (shape.paired)
            fish.addPair(coloured);
        else
            fish.add(coloured);
    }
    fish.addPair(painted(
        globe(shark.eye, shark.eyeRadius, shark.rings > 30 ? 8 : 4, shark.rings > 30 ? 10 : 6), 0x0A0A0C));
    return fish.take();
}

} // namespace

// A great white: a spindle, grey above and white below with a sharp line between, and a tail like a crescent.
Mesh shark() {
    const Paint skin = [](const glm::dvec3& p) {
        const double line = -0.020 + 0.012 * std::sin(22.0 * p.x);
        return glm::mix(rgb(0xEDEDE8), rgb(0x4E5A64), ramp(line - 0.012, line + 0.012, p.y));
    };
    return swimmer(
        {.trunk = {{0.500, 0.020, 0.020, 0.000},
                   {0.470, 0.042, -0.006, 0.022},
                   {0.410, 0.072, -0.040, 0.050},
                   {0.320, 0.102, -0.082, 0.076},
                   {0.200, 0.124, -0.114, 0.094},
                   {0.060, 0.126, -0.118, 0.096},
                   {-0.090, 0.104, -0.094, 0.076},
                   {-0.230, 0.066, -0.056, 0.046},
                   {-0.340, 0.034, -0.022, 0.026},
                   {-0.400, 0.026, -0.012, 0.022},
                   {-0.440, 0.008, 0.008, 0.000}},
         .rings = 20,
         .sides = 12,
         .fins = {{{{-0.395, 0.030, 0}, {-0.415, 0.008, 0}, {-0.395, -0.014, 0}},
                   {{-0.530, 0.235, 0},
                    {-0.480, 0.090, 0},
                    {-0.455, 0.010, 0},
                    {-0.470, -0.080, 0},
                    {-0.515, -0.190, 0}}},
                  {{{0.110, 0.110, 0}, {-0.010, 0.105, 0}}, {{-0.010, 0.275, 0}, {-0.035, 0.270, 0}}},
                  {{{-0.240, 0.056, 0}, {-0.275, 0.048, 0}}, {{-0.290, 0.088, 0}, {-0.305, 0.082, 0}}},
                  {{{-0.240, -0.046, 0}, {-0.275, -0.038, 0}}, {{-0.290, -0.080, 0}, {-0.305, -0.074, 0}}},
                  {{{0.230, -0.060, 0.075}, {0.110, -0.070, 0.080}},
                   {{0.055, -0.150, 0.310}, {0.030, -0.145, 0.300}},
                   true},
                  {{{-0.120, -0.075, 0.030}, {-0.180, -0.060, 0.026}},
                   {{-0.180, -0.125, 0.080}, {-0.200, -0.115, 0.076}},
                   true}},
         .finCells = {3, 12},
         .skin = skin,
         .finSkin = likeFlank(skin),
         .eye = {0.418, 0.026, 0.046},
         .eyeRadius = 0.012,
         .gills = 0.290,
         .mouth = {0.375, -0.040},
         .noseY = -0.012,
         .bend = 0.07});
}

// Slender, with two fins of a size on its back, a long low tail, dark saddles and spots between them.
Mesh leopardShark() {
    const Paint skin = [](const glm::dvec3& p) {
        const glm::dvec3 colour = glm::mix(rgb(0xEFEBDC), rgb(0xA89A82), ramp(-0.055, 0.005, p.y));
        double saddle = 0.0;
        for (int i = 0; i < 10; ++i) {
            const double wave = 0.010 * std::sin(40.0 * p.y + 2.0 * i);
            saddle = std::max(saddle, bump(0.360 - 0.082 * i + wave, 0.030, p.x) * ramp(-0.004, 0.016, p.y));
        }
        const double spot = (1.0 - ramp(0.16, 0.30, flankScatter(p, 0.070))) * ramp(-0.050, -0.035, p.y) *
                            (1.0 - ramp(0.010, 0.022, p.y)) * (1.0 - ramp(0.38, 0.42, p.x));
        const double hollow = 0.45 * bump(0.034, 0.016, p.y); // saddles are paler inside
        return glm::mix(colour, rgb(0x2A241C), std::max(ramp(0.20, 0.45, saddle) * (1.0 - hollow), spot));
    };
    return swimmer(
        {.trunk = {{0.500, -0.006, -0.006, 0.000},
                   {0.485, 0.012, -0.020, 0.024},
                   {0.440, 0.030, -0.034, 0.044},
                   {0.370, 0.048, -0.048, 0.056},
                   {0.270, 0.064, -0.060, 0.060},
                   {0.150, 0.072, -0.066, 0.058},
                   {0.020, 0.066, -0.058, 0.048},
                   {-0.120, 0.050, -0.042, 0.034},
                   {-0.250, 0.036, -0.026, 0.022},
                   {-0.340, 0.026, -0.016, 0.014},
                   {-0.420, 0.030, 0.000, 0.007},
                   {-0.450, 0.018, 0.018, 0.000}},
         .rings = 62,
         .sides = 26,
         .fins = {{{{-0.310, 0.028, 0}, {-0.400, 0.026, 0}, {-0.400, 0.004, 0}, {-0.330, -0.014, 0}},
                   {{-0.440, 0.080, 0}, {-0.530, 0.110, 0}, {-0.470, 0.020, 0}, {-0.390, -0.066, 0}}},
                  {{{0.150, 0.064, 0}, {0.070, 0.062, 0}, {0.040, 0.060, 0}},
                   {{0.085, 0.145, 0}, {0.055, 0.155, 0}, {0.015, 0.080, 0}}},
                  {{{-0.110, 0.046, 0}, {-0.170, 0.042, 0}, {-0.200, 0.038, 0}},
                   {{-0.165, 0.118, 0}, {-0.195, 0.122, 0}, {-0.228, 0.056, 0}}},
                  {{{-0.190, -0.028, 0}, {-0.240, -0.022, 0}}, {{-0.235, -0.072, 0}, {-0.268, -0.050, 0}}},
                  {{{0.300, -0.036, 0.052}, {0.260, -0.042, 0.054}, {0.215, -0.042, 0.050}},
                   {{0.215, -0.075, 0.180}, {0.165, -0.072, 0.175}, {0.160, -0.060, 0.110}},
                   true},
                  {{{-0.010, -0.048, 0.026}, {-0.070, -0.040, 0.024}},
                   {{-0.060, -0.080, 0.085}, {-0.105, -0.070, 0.070}},
                   true}},
         .finCells = {6, 24},
         .skin = skin,
         .finSkin = [](const glm::dvec3& p) { return rgb(0xA09078) * (0.8 + 0.3 * noise(p, 0.05)); },
         .eye = {0.425, 0.016, 0.042},
         .eyeRadius = 0.009,
         .gills = 0.315,
         .mouth = {0.400, -0.034},
         .noseY = -0.018,
         .bend = 0.16});
}

// Heavy in front, with a fin on its back as high as the body is deep, and long wings.
Mesh sandBarShark() {
    const Paint skin = [](const glm::dvec3& p) {
        return glm::mix(rgb(0xF1EADB), rgb(0x80705A), ramp(-0.060, 0.020, p.y)) *
               (1.0 - 0.25 * ramp(0.04, 0.10, p.y)) * (0.95 + 0.10 * noise(p, 0.04));
    };
    return swimmer(
        {.trunk = {{0.500, 0.000, 0.000, 0.000},
                   {0.488, 0.018, -0.016, 0.030},
                   {0.445, 0.040, -0.036, 0.058},
                   {0.375, 0.068, -0.062, 0.074},
                   {0.290, 0.096, -0.084, 0.084},
                   {0.190, 0.118, -0.096, 0.088},
                   {0.070, 0.112, -0.094, 0.080},
                   {-0.070, 0.080, -0.070, 0.058},
                   {-0.200, 0.052, -0.042, 0.036},
                   {-0.310, 0.032, -0.020, 0.020},
                   {-0.380, 0.028, -0.008, 0.013},
                   {-0.425, 0.010, 0.010, 0.000}},
         .rings = 60,
         .sides = 26,
         .fins = {{{{-0.345, 0.030, 0}, {-0.400, 0.016, 0}, {-0.360, -0.010, 0}},
                   {{-0.520, 0.200, 0},
                    {-0.505, 0.170, 0},
                    {-0.430, 0.030, 0},
                    {-0.415, -0.010, 0},
                    {-0.430, -0.105, 0},
                    {-0.405, -0.095, 0}}},
                  {{{0.255, 0.096, 0}, {0.150, 0.108, 0}, {0.070, 0.100, 0}},
                   {{0.115, 0.290, 0}, {0.085, 0.300, 0}, {0.030, 0.125, 0}}},
                  {{{-0.180, 0.050, 0}, {-0.235, 0.042, 0}}, {{-0.225, 0.098, 0}, {-0.270, 0.064, 0}}},
                  {{{-0.190, -0.040, 0}, {-0.235, -0.032, 0}}, {{-0.230, -0.088, 0}, {-0.270, -0.054, 0}}},
                  {{{0.270, -0.046, 0.074}, {0.210, -0.056, 0.078}, {0.150, -0.056, 0.076}},
                   {{0.130, -0.105, 0.315}, {0.095, -0.100, 0.310}, {0.105, -0.070, 0.170}},
                   true},
                  {{{-0.060, -0.066, 0.030}, {-0.130, -0.054, 0.026}},
                   {{-0.120, -0.105, 0.095}, {-0.165, -0.088, 0.075}},
                   true}},
         .finCells = {6, 26},
         .skin = skin,
         .finSkin = likeFlank(skin),
         .eye = {0.425, 0.020, 0.056},
         .eyeRadius = 0.009,
         .gills = 0.300,
         .mouth = {0.395, -0.044},
         .noseY = -0.022,
         .bend = -0.09});
}

} // namespace limpid::models
