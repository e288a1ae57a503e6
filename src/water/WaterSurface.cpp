#include "water/WaterSurface.h"

#include <vector>

#include "gl/Bindings.h"
#include "plan/WaveTerms.h"

namespace limpid {

namespace {

constexpr int groupSize = 64;

std::vector<std::uint32_t> gridTriangles(glm::ivec2 quads) {
    std::vector<std::uint32_t> indices;
    indices.reserve(std::size_t(quads.x) * std::size_t(quads.y) * 6);
    for (int z = 0; z < quads.y; ++z)
        for (int x = 0; x < quads.x; ++x) {
            const auto a = std::uint32_t(z * (quads.x + 1) + x), b = a + 1;
            const auto c = a + std::uint32_t(quads.x) + 1, d = c + 1;
            if ((x + z) % 2 == 0)
                indices.insert(indices.end(), {a, c, b, b, c, d});
            else
                indices.insert(indices.end(), {a, c, d, a, d, b});
        }
    return indices;
}

/// All along x, then all along z, m from the scene's origin; empty where quads are equally wide.
gl::Buffer linesOf(gl::Ledger& ledger, const WaterPatch& patch, const glm::dvec3& origin) {
    if (patch.lines[0].empty()) return {};
    const glm::dvec2 corner = patch.min() - glm::dvec2(origin.x, origin.z);
    std::vector<float> all;
    for (const int axis : {0, 1})
        for (const double line : patch.lines[std::size_t(axis)])
            all.push_back(float(corner[axis] + line));
    return {ledger, "water", std::span<const float>(all)};
}

} // namespace

WaterSurface::WaterSurface(gl::Context& context)
    : _context(context), _program({"water/surface.comp"}), _heightMaps(context) {}

void WaterSurface::resize(glm::ivec2 grid) {
    if (grid == _grid) return;
    _grid = {}; // until all is there: memory may run out
    const auto indices = gridTriangles(grid);
    _mesh.quads = grid;
    _mesh.vertexCount = (grid.x + 1) * (grid.y + 1);
    _mesh.triangleCount = int(indices.size() / 3);
    const auto bytes = std::int64_t(_mesh.vertexCount) * std::int64_t(sizeof(glm::vec4));
    _mesh.positions = gl::Buffer(_context.ledger(), "water", bytes);
    _mesh.normals = gl::Buffer(_context.ledger(), "water", bytes);
    _mesh.indices = gl::Buffer(_context.ledger(), "water", std::span<const std::uint32_t>(indices));
    _grid = grid;
}

void WaterSurface::update(const Water& water, const WaterPatch& patch, const glm::dvec3& origin,
                          double time) {
    resize(patch.grid);
    const std::vector<HeightMapData> maps =
        _heightMaps.bind(water, origin, time); // may run passes of its own
    const auto terms = waveTerms(water, origin, time);
    const gl::Buffer waves(_context.ledger(), "waves", std::span<const gpu::WaveTerm>(terms));
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT |
                    GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT); // draws of the last picture
    waves.bindStorage(wavesBuffer);
    _mesh.positions.bindStorage(positionsBuffer);
    _mesh.normals.bindStorage(normalsBuffer);
    _program.set(patchMinLocation, glm::vec2(patch.min() - glm::dvec2(origin.x, origin.z)));
    _program.set(patchSizeLocation, glm::vec2(patch.size));
    _program.set(quadsLocation, patch.grid);
    _program.set(levelLocation, float(water.level - origin.y));
    const gl::Buffer lines = linesOf(_context.ledger(), patch, origin);
    _program.set(hasLinesLocation, lines.id() ? 1 : 0);
    if (lines.id()) lines.bindStorage(gridLinesBuffer);
    _program.set(waveCountLocation, int(terms.size()));
    _program.set(frameCountLocation, int(2 * maps.size()));
    for (int i = 0; i < int(maps.size()); ++i) {
        const HeightMapData& map = maps[std::size_t(i)];
        _program.set(heightMapPlacesLocation + i, map.place);
        _program.set(frameSharesLocation + 2 * i, map.shares.x);
        _program.set(frameSharesLocation + 2 * i + 1, map.shares.y);
        _program.set(tiledLocation + i, map.tiled ? 1 : 0);
    }
    _program.dispatch(_mesh.vertexCount, groupSize);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT);
}

} // namespace limpid
