#include "FishParts.h"
#include "Models.h"
#include "Shapes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>

namespace limpid::models {

namespace {

// It drives along +x; sizes in the length of its hull.

constexpr unsigned steel = 0x3C3E3A, rubber = 0x1C1C1C, wood = 0x7A5A34;
constexpr double trackMiddle = 0.205, trackHalfWidth = 0.048;

// Green paint with brown patches.
glm::dvec3 camouflage(const glm::dvec3& p) {
    const glm::dvec3 green = glm::mix(rgb(0x5C6B3A), rgb(0x4C5A30), noise(p, 0.03));
    return glm::mix(green, rgb(0x6E5230), ramp(0.56, 0.62, noise(p + 7.0, 0.11)));
}

Shell armoured(const Shell& shell) {
    return painted(shell, camouflage);
}

/// The track's path: points evenly spaced, with the way it runs there.
struct Station {
    glm::dvec2 place, ahead;
};

// Around sprocket, road wheels and idler, and back with a little slack above.
std::vector<Station> trackPath(int links) {
    std::vector<glm::dvec3> loop;
    const auto arc = [&](double x, double y, double r, double from, double to) {
        for (int i = 0; i <= 10; ++i) {
            const double angle = glm::radians(glm::mix(from, to, i / 10.0));
            loop.emplace_back(x + r * std::cos(angle), y + r * std::sin(angle), 0.0);
        }
    };
    arc(0.420, 0.120, 0.062, 90.0, -55.0);
    for (int i = 0; i <= 10; ++i)
        loop.emplace_back(glm::mix(0.325, -0.315, i / 10.0), 0.012, 0.0);
    arc(-0.410, 0.118, 0.062, 235.0, 90.0);
    for (int i = 1; i < 10; ++i) {
        const double t = i / 10.0;
        loop.emplace_back(glm::mix(-0.410, 0.420, t),
                          0.181 - 0.006 * std::sin(3.0 * glm::pi<double>() * t) *
                                      std::sin(3.0 * glm::pi<double>() * t),
                          0.0);
    }
    loop.push_back(loop.front());
    std::vector<double> lengths{0.0};
    for (std::size_t i = 1; i < loop.size(); ++i)
        lengths.push_back(lengths.back() + glm::distance(loop[i], loop[i - 1]));
    std::vector<Station> stations;
    std::size_t piece = 1;
    for (int link = 0; link < links; ++link) {
        const double at = lengths.back() * link / links;
        while (lengths[piece] < at)
            ++piece;
        const double t = (at - lengths[piece - 1]) / (lengths[piece] - lengths[piece - 1]);
        const glm::dvec3 ahead = glm::normalize(loop[piece] - loop[piece - 1]);
        stations.push_back({glm::dvec2{glm::mix(loop[piece - 1], loop[piece], t)}, glm::dvec2{ahead}});
    }
    return stations;
}

// One link lies with its outside up: a plate, a grouser, and a horn that guides it between the wheels.
void addLinks(Assembly& tank, double z) {
    const int links = 72;
    const Shell plate = block({-0.0125, -0.006, -trackHalfWidth}, {0.0125, 0.004, trackHalfWidth});
    const Shell grouser =
        block({-0.004, 0.003, -trackHalfWidth + 0.004}, {0.004, 0.011, trackHalfWidth - 0.004});
    const Shell horn = block({-0.005, -0.022, -0.005}, {0.005, -0.005, 0.005});
    for (const Station& station : trackPath(links)) {
        const double angle = glm::degrees(std::atan2(-station.ahead.y, -station.ahead.x)) + 180.0;
        for (const Shell* part : {&plate, &grouser, &horn})
            tank.add(painted(moved(turned(*part, 2, angle), {station.place, z}),
                             part == &plate ? steel : 0x55564E),
                     30.0);
    }
}

Shell wheelAt(const Shell& shell, double x, double y, double z) {
    return moved(turned(shell, 0, 90.0), {x, y, z});
}

void addWheels(Assembly& tank, double side) {
    const double z = trackMiddle;
    const auto add = [&](const Shell& shell, bool painting, unsigned colour) {
        const Shell part = painting ? armoured(shell) : painted(shell, colour);
        tank.add(side > 0.0 ? part : mirroredInZ(part), 30.0);
    };
    const double r = 0.060;
    const Shell tyre = lathe({{0.80 * r, -0.014}, {r, -0.014}, {r, 0.014}, {0.80 * r, 0.014}}, 20);
    const Shell disc = lathe({{0.0, -0.012},
                              {0.81 * r, -0.012},
                              {0.81 * r, 0.012},
                              {0.70 * r, 0.012},
                              {0.62 * r, 0.004},
                              {0.34 * r, 0.006},
                              {0.30 * r, 0.018},
                              {0.16 * r, 0.022},
                              {0.0, 0.022}},
                             20);
    for (int i = 0; i < 6; ++i)
        for (double dz : {-0.024, 0.028}) {
            const double x = -0.300 + 0.122 * i;
            add(wheelAt(tyre, x, 0.080, z + dz), false, rubber);
            add(wheelAt(disc, x, 0.080, z + dz), true, 0);
        }
    // Idler in front, sprocket with teeth behind, three return rollers.
    add(wheelAt(lathe({{0.0, -0.030},
                       {0.052, -0.030},
                       {0.052, -0.012},
                       {0.040, -0.006},
                       {0.040, 0.006},
                       {0.052, 0.012},
                       {0.052, 0.030},
                       {0.036, 0.032},
                       {0.012, 0.042},
                       {0.0, 0.042}},
                      28),
                0.420, 0.120, z),
        true, 0);
    const Shell sprocket = shaped(lathe({{0.0, -0.030},
                                         {0.058, -0.030},
                                         {0.058, -0.016},
                                         {0.030, -0.012},
                                         {0.030, 0.012},
                                         {0.058, 0.016},
                                         {0.058, 0.030},
                                         {0.030, 0.034},
                                         {0.014, 0.046},
                                         {0.0, 0.046}},
                                        64),
                                  [](const glm::dvec3& p) {
                                      const double radius = std::hypot(p.x, p.z);
                                      const bool gap = std::sin(16.0 * std::atan2(p.z, p.x) + 0.8) > 0.0;
                                      const double scale = radius > 0.050 && gap ? 0.86 : 1.0;
                                      return glm::dvec3{p.x * scale, p.y, p.z * scale};
                                  });
    add(wheelAt(sprocket, -0.410, 0.118, z), true, 0);
    for (double x : {-0.200, 0.010, 0.220})
        add(wheelAt(lathe({{0.0, -0.024}, {0.022, -0.024}, {0.022, 0.024}, {0.0, 0.024}}, 16), x, 0.148, z),
            true, 0);
}

void addHull(Assembly& tank) {
    const auto add = [&](const Shell& shell) { tank.add(armoured(shell), 20.0); };
    add(slab(
        {{-0.440, 0.150}, {-0.380, 0.062}, {0.380, 0.062}, {0.455, 0.150}, {0.330, 0.235}, {-0.400, 0.235}},
        -0.150, 0.150, 0.008));
    add(slab({{-0.455, 0.196}, {0.390, 0.196}, {0.330, 0.238}, {-0.405, 0.238}}, -0.255, 0.255,
             0.005)); // over the tracks
    for (double z : {trackMiddle, -trackMiddle}) {
        add(block({-0.480, 0.190, z - 0.055}, {0.420, 0.197, z + 0.055}, 0.002)); // track guard
        add(slab({{0.415, 0.190}, {0.475, 0.165}, {0.478, 0.170}, {0.420, 0.197}}, z - 0.055,
                 z + 0.055)); // mud flap
    }
    for (int i = 0; i < 7; ++i) // the engine's grille
        tank.add(
            painted(block({-0.380 + 0.022 * i, 0.234, -0.100}, {-0.368 + 0.022 * i, 0.244, 0.100}), steel));
    for (double z : {0.060, -0.060}) { // exhausts, drums
        tank.add(painted(
            rod({{-0.400, 0.190, z}, {-0.460, 0.195, z}, {-0.485, 0.210, z}}, {0.016, 0.016, 0.014}, 4, 12),
            steel));
        const Shell drum = lathe({{0.0, -0.090},
                                  {0.040, -0.088},
                                  {0.040, -0.030},
                                  {0.043, -0.026},
                                  {0.040, -0.022},
                                  {0.040, 0.022},
                                  {0.043, 0.026},
                                  {0.040, 0.030},
                                  {0.040, 0.088},
                                  {0.0, 0.090}},
                                 24);
        tank.add(armoured(moved(turned(drum, 0, 90.0), {-0.455, 0.262, 1.75 * z})), 30.0);
    }
    // Headlamps, the driver's hatch and port, the bow gun.
    for (double z : {0.110, -0.110}) {
        const Shell lamp =
            smoothLathe({{0.0, -0.020}, {0.014, -0.016}, {0.018, 0.0}, {0.016, 0.006}, {0.0, 0.010}}, 2, 16);
        tank.add(painted(moved(turned(lamp, 2, -90.0), {0.392, 0.222, z}), 0xE8E4C8));
    }
    const Shell hatch = lathe({{0.0, 0.0}, {0.046, 0.0}, {0.046, 0.006}, {0.038, 0.012}, {0.0, 0.014}}, 24);
    for (double z : {0.085, -0.085})
        add(moved(hatch, {0.280, 0.234, z}));
    add(moved(turned(block({-0.008, 0.0, -0.030}, {0.008, 0.020, 0.030}, 0.003), 2, -56.0),
              {0.385, 0.192, 0.080}));
    add(moved(globe({0, 0, 0}, 0.026, 10, 16), {0.392, 0.188, -0.080}));
    tank.add(painted(rod({{0.400, 0.190, -0.080}, {0.470, 0.194, -0.080}}, {0.006, 0.005}, 1, 8), steel));
    // Tools and a tow rope on the guards.
    tank.add(painted(rod({{-0.300, 0.247, 0.235}, {-0.060, 0.247, 0.235}}, {0.006, 0.006}, 1, 8), wood));
    tank.add(painted(block({-0.060, 0.240, 0.218}, {-0.010, 0.250, 0.250}, 0.003), steel));
    tank.add(painted(rod({{-0.350, 0.246, -0.235},
                          {-0.150, 0.246, -0.245},
                          {0.050, 0.246, -0.228},
                          {0.250, 0.246, -0.240}},
                         {0.006, 0.006, 0.006, 0.006}, 6, 8),
                     0x6A6A60));
}

// A cast turret: its plan drawn in as it rises.
Shell turretShell() {
    const std::vector<glm::dvec2> plan = rounded({{0.190, -0.085},
                                                  {0.190, 0.085},
                                                  {0.100, 0.150},
                                                  {-0.110, 0.150},
                                                  {-0.230, 0.090},
                                                  {-0.230, -0.090},
                                                  {-0.110, -0.150},
                                                  {0.100, -0.150}},
                                                 0.060, 5);
    const Shell raised = turned(slab(plan, 0.0, 0.125, 0.022), 0, -90.0);
    return shaped(raised, [](const glm::dvec3& p) {
        const double drawn = 1.0 - 0.28 * (p.y / 0.125);
        return glm::dvec3{p.x * drawn, p.y, p.z * drawn};
    });
}

// The turret looks a little to one side.
Shell turret(const Shell& shell) {
    return moved(turned(shell, 1, 14.0), {0.020, 0.240, 0.0});
}

void addTurret(Assembly& tank) {
    const auto add = [&](const Shell& shell, double crease) { tank.add(armoured(turret(shell)), crease); };
    add(turretShell(), 35.0);
    add(lathe({{0.0, -0.010}, {0.150, -0.010}, {0.150, 0.004}, {0.0, 0.004}}, 48), 30.0); // ring
    // Mantlet and gun, which points along +x.
    add(moved(cushion({0, 0, 0}, {0.045, 0.048, 0.085}, 3.0, 10), {0.165, 0.062, 0.0}), 50.0);
    const auto barrel = [&](const std::vector<glm::dvec2>& outline, int sides) {
        add(moved(turned(lathe(outline, sides), 2, -90.0), {0.180, 0.064, 0.0}), 30.0);
    };
    barrel({{0.0, 0.0}, {0.036, 0.0}, {0.034, 0.050}, {0.024, 0.062}, {0.0, 0.062}}, 28);
    barrel({{0.0, 0.050},
            {0.021, 0.050},
            {0.018, 0.200},
            {0.025, 0.205},
            {0.025, 0.270},
            {0.018, 0.275},
            {0.015, 0.420},
            {0.0, 0.420}},
           28);
    barrel({{0.0, 0.415},
            {0.024, 0.418},
            {0.026, 0.430},
            {0.026, 0.470},
            {0.022, 0.478},
            {0.012, 0.478},
            {0.011, 0.440},
            {0.0, 0.438}},
           28); // muzzle brake
    // Cupola with its blocks, the loader's hatch, ventilator, aerial.
    const auto top = [&](const Shell& shell, double x, double y, double z, double crease) {
        add(moved(shell, {x, y, z}), crease);
    };
    top(lathe({{0.0, 0.0}, {0.058, 0.0}, {0.056, 0.030}, {0.050, 0.036}, {0.0, 0.038}}, 32), -0.070, 0.118,
        0.052, 30.0);
    top(smoothLathe({{0.0, 0.0}, {0.044, 0.0}, {0.040, 0.010}, {0.0, 0.014}}, 3, 28), -0.070, 0.153, 0.052,
        40.0);
    for (int i = 0; i < 8; ++i) {
        const Shell periscope =
            turned(block({0.046, 0.012, -0.009}, {0.062, 0.030, 0.009}, 0.002), 1, 45.0 * i + 10.0);
        tank.add(painted(turret(moved(periscope, {-0.070, 0.118, 0.052})), 0x1C2428), 30.0);
    }
    top(lathe({{0.0, 0.0}, {0.046, 0.0}, {0.046, 0.008}, {0.038, 0.014}, {0.0, 0.016}}, 28), -0.050, 0.120,
        -0.058, 30.0);
    top(smoothLathe({{0.0, 0.0}, {0.024, 0.0}, {0.022, 0.016}, {0.0, 0.024}}, 3, 20), 0.060, 0.118, 0.0,
        40.0);
    tank.add(painted(turret(rod({{-0.130, 0.115, -0.070}, {-0.136, 0.230, -0.071}, {-0.150, 0.340, -0.073}},
                                {0.003, 0.002, 0.0015}, 3, 6)),
                     steel));
}

// A machine gun on the cupola, hand rails, stowage behind.
void addTurretFittings(Assembly& tank) {
    tank.add(
        painted(turret(rod({{-0.050, 0.178, 0.052}, {0.120, 0.184, 0.052}}, {0.007, 0.004}, 2, 10)), steel));
    tank.add(painted(turret(block({-0.090, 0.168, 0.040}, {-0.020, 0.188, 0.064}, 0.003)), steel), 30.0);
    for (double z : {0.138, -0.138})
        tank.add(painted(
            turret(rod(
                {{0.050, 0.060, 0.93 * z}, {0.040, 0.068, z}, {-0.070, 0.068, z}, {-0.080, 0.060, 0.93 * z}},
                {0.004, 0.004, 0.004, 0.004}, 3, 6)),
            steel));
    tank.add(armoured(turret(block({-0.262, 0.020, -0.080}, {-0.195, 0.080, 0.080}, 0.006))), 30.0);
}

} // namespace

Mesh tank() {
    Assembly tank;
    addHull(tank);
    for (double side : {1.0, -1.0}) {
        addWheels(tank, side);
        addLinks(tank, side * trackMiddle);
    }
    addTurret(tank);
    addTurretFittings(tank);
    return tank.take();
}

} // namespace limpid::models
