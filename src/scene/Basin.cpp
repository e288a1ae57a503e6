#include "scene/Basin.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "scene/Voxels.h"

namespace limpid {

namespace {

// What tells a basin from a dent, as shares of the mesh's box. The least pool, tub or lake that was tried has
// 0.06 of the plan and, with an open surface throughout, 0.33 of the height; a teapot's spout has 0.12 of its
// surface open, a parapet holds 0.1 of a house's height, rolling ground has 28 ponds of 0.04 of all water
// each.
constexpr double leastPlan = 0.02;   ///< of its plan
constexpr double leastDepth = 0.06;  ///< of its height
constexpr double shallow = 0.25;     ///< of its height; a shallower basin must start below that
constexpr double leastOpen = 0.75;   ///< of the basin's plan
constexpr double leastOfAll = 0.4;   ///< of the plan of all water that stays
constexpr double levelNormal = 0.8;  ///< least |y| of the unit normal of a water surface, waves included
constexpr double leastSurface = 0.5; ///< of the basin's plan

constexpr int layers = Voxels::count;
using Columns = std::vector<int>; ///< a number for each x and z
std::size_t columnOf(const glm::ivec3& at) {
    return std::size_t(at.z * layers + at.x);
}

/// Calls `visit(cell)` for the cells that share a face with one, within the box.
template <typename Visit>
void forEachBeside(std::size_t cell, const Visit& visit) {
    const glm::ivec3 at = Voxels::place(cell);
    for (int axis = 0; axis < 3; ++axis)
        for (const int step : {-1, 1}) {
            glm::ivec3 beside = at;
            beside[axis] += step;
            if (beside[axis] >= 0 && beside[axis] < layers) visit(Voxels::index(beside));
        }
}

/// A triangle of the mesh, where it is and how it looks.
struct Face {
    std::array<glm::dvec3, 3> corners;
    bool clear;  ///< light goes through
    double plan; ///< area seen from above, m²
    bool level;

    Face(const Mesh& mesh, std::size_t first, bool seeThrough) : clear(seeThrough) {
        for (std::size_t c = 0; c < 3; ++c)
            corners[c] = mesh.positions[mesh.indices[first + c]];
        const glm::dvec3 across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        plan = 0.5 * std::abs(across.y);
        level = std::abs(across.y) >= levelNormal * glm::length(across);
    }
    glm::dvec3 middle() const { return (corners[0] + corners[1] + corners[2]) / 3.0; }
};

std::vector<Face> facesOf(const Mesh& mesh) {
    std::vector<Face> faces;
    faces.reserve(mesh.triangleCount());
    for (const MeshPart& part : mesh.parts) {
        const Material& material = mesh.materials[std::size_t(part.material)];
        const bool clear = material.alphaMode == AlphaMode::Blend || material.transmission > 0;
        for (std::size_t i = 0; i + 2 < part.indexCount; i += 3)
            faces.emplace_back(mesh, part.firstIndex + i, clear);
    }
    return faces;
}

/// Of each cell that water can leave, the highest layer that it must pass to get out, at the least (priority
/// flood: Barnes, Lehman and Mulla 2014, on cells in place of a height field). -1: solid, or shut in.
std::vector<std::int8_t> spillLayers(const Voxels& voxels) {
    std::vector<std::int8_t> spill(std::size_t(layers) * layers * layers, -1);
    std::vector<std::vector<std::size_t>> waiting(layers);
    const auto reach = [&](std::size_t cell, int layer) {
        if (spill[cell] >= 0 || voxels.solid(cell)) return;
        spill[cell] = std::int8_t(std::max(layer, Voxels::place(cell).y));
        waiting[std::size_t(spill[cell])].push_back(cell);
    };
    for (std::size_t cell = 0; cell < spill.size(); ++cell) {
        const glm::ivec3 at = Voxels::place(cell);
        if (glm::any(glm::equal(at, glm::ivec3(0))) || glm::any(glm::equal(at, glm::ivec3(layers - 1))))
            reach(cell, at.y);
    }
    for (int layer = 0; layer < layers; ++layer)
        for (auto& cells = waiting[std::size_t(layer)]; !cells.empty();) {
            const std::size_t cell = cells.back();
            cells.pop_back();
            forEachBeside(cell, [&](std::size_t beside) { reach(beside, layer); });
        }
    return spill;
}

/// Water that stays, from its lowest layer up to the one that it runs off over.
struct Pond {
    int spill = 0;
    glm::ivec3 low{layers}, high{0}; ///< cells
    int plan = 0, open = 0;          ///< columns; those whose surface has nothing above
    int cells = 0;
};

/// Where water stays on a mesh.
struct Flood {
    std::vector<std::int8_t> spill;
    Columns tops; ///< highest solid cell

    explicit Flood(const Voxels& voxels) : spill(spillLayers(voxels)), tops(layers * layers, 0) {
        for (std::size_t cell = 0; cell < spill.size(); ++cell) {
            const glm::ivec3 at = Voxels::place(cell);
            if (voxels.solid(cell)) tops[columnOf(at)] = std::max(tops[columnOf(at)], at.y);
        }
    }
    bool holdsWater(std::size_t cell) const { return spill[cell] > Voxels::place(cell).y; }
};

/// The pond that `cell` is in, the `number`th. `filled`: cells; `seen`: the last pond of each column.
Pond pondAt(const Flood& flood, std::size_t cell, int number, std::vector<bool>& filled, Columns& seen) {
    Pond pond;
    pond.spill = flood.spill[cell];
    std::vector<std::size_t> waiting{cell};
    filled[cell] = true;
    while (!waiting.empty()) {
        const std::size_t own = waiting.back();
        waiting.pop_back();
        const glm::ivec3 at = Voxels::place(own);
        const std::size_t column = columnOf(at);
        ++pond.cells;
        pond.low = glm::min(pond.low, at), pond.high = glm::max(pond.high, at);
        if (seen[column] != number) ++pond.plan;
        seen[column] = number;
        if (at.y == pond.spill - 1 && flood.tops[column] < at.y) ++pond.open;
        forEachBeside(own, [&](std::size_t beside) {
            if (filled[beside] || !flood.holdsWater(beside)) return;
            filled[beside] = true;
            waiting.push_back(beside);
        });
    }
    return pond;
}

/// The pond that is a basin.
std::optional<Pond> widestPond(const Voxels& voxels) {
    const Flood flood(voxels);
    std::vector<bool> filled(flood.spill.size(), false);
    Columns seen(layers * layers, -1);
    Pond widest;
    int number = 0, plan = 0;
    for (std::size_t cell = 0; cell < filled.size(); ++cell) {
        if (filled[cell] || !flood.holdsWater(cell)) continue;
        const Pond pond = pondAt(flood, cell, number++, filled, seen);
        if (pond.open < leastOpen * pond.plan) continue;
        plan += pond.plan;
        if (pond.plan > widest.plan) widest = pond;
    }
    const int depth = widest.spill - widest.low.y;
    const bool low = widest.low.y - 1 < shallow * Voxels::side;
    const bool deep = depth >= (low ? leastDepth : shallow) * Voxels::side;
    const bool wide = widest.plan >= leastPlan * Voxels::side * Voxels::side;
    if (!deep || !wide || widest.plan < leastOfAll * plan) return std::nullopt;
    return widest;
}

Basin basinOf(const Pond& pond, const Voxels& voxels) {
    Basin basin;
    // The rim lies in the layer below the one that water runs off over.
    basin.water.add(voxels.corner({pond.low.x, pond.low.y, pond.low.z}));
    basin.water.add(voxels.corner({pond.high.x + 1, pond.spill - 1, pond.high.z + 1}));
    const double layer = voxels.corner({0, 1, 0}).y - voxels.corner({0, 0, 0}).y;
    basin.depth = layer * pond.cells / pond.plan;
    return basin;
}

/// y of the clear, level faces in a basin that cover half of it, `plan` m²; of a body those of its top.
std::optional<double> surfaceIn(const Bounds& water, double plan, const std::vector<Face>& faces) {
    std::vector<const Face*> inside;
    Bounds range;
    for (const Face& face : faces) {
        const glm::dvec3 middle = face.middle();
        if (!face.clear || !face.level || glm::any(glm::lessThan(middle, water.min)) ||
            glm::any(glm::greaterThan(middle, water.max)))
            continue;
        inside.push_back(&face);
        range.add(middle);
    }
    double area = 0, sum = 0;
    for (const Face* face : inside)
        if (const double y = face->middle().y; y >= range.center().y)
            area += face->plan, sum += face->plan * y;
    return area >= leastSurface * plan ? std::optional(sum / area) : std::nullopt;
}

/// Which clear faces hold water.
enum class Glass { None, Steep, All };

std::optional<Basin> findBasin(const Bounds& box, const std::vector<Face>& faces, Glass glass) {
    Voxels voxels(box);
    for (const Face& face : faces)
        if (!face.clear || glass == Glass::All || (glass == Glass::Steep && !face.level))
            voxels.add(face.corners);
    const std::optional<Pond> pond = widestPond(voxels);
    if (!pond) return std::nullopt;
    Basin basin = basinOf(*pond, voxels);
    const glm::dvec3 size = box.size() / double(Voxels::side);
    if (glass != Glass::All) basin.surface = surfaceIn(basin.water, size.x * size.z * pond->plan, faces);
    return basin;
}

} // namespace

std::optional<Basin> findBasin(const Mesh& mesh) {
    Bounds box;
    for (const glm::dvec3& p : mesh.positions)
        box.add(p);
    const glm::dvec3 size = box.size();
    const double longest = std::max({size.x, size.y, size.z}), shortest = std::min({size.x, size.y, size.z});
    // Cells must tell places apart, and products of sizes must stay finite.
    if (box.empty() || !(shortest > 1e-6 * longest) || !(longest < 1e100) || !(longest > 1e-100))
        return std::nullopt;
    const std::vector<Face> faces = facesOf(mesh);
    if (std::none_of(faces.begin(), faces.end(), [](const Face& face) { return face.clear; }))
        return findBasin(box, faces, Glass::None);
    for (const Glass glass : {Glass::None, Glass::Steep, Glass::All})
        if (const std::optional<Basin> basin = findBasin(box, faces, glass)) return basin;
    return std::nullopt;
}

} // namespace limpid
