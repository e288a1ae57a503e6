#include "caustics/BeamTiles.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <string>
#include <vector>

#include "core/ShaderData.h"
#include "gl/Bindings.h"

namespace limpid {

namespace {
constexpr int groupSize = 64;
using gpu::tileQuads;

glm::ivec2 tilesOf(glm::ivec2 quads) {
    return (quads + tileQuads - 1) / tileQuads;
}
} // namespace

std::int64_t BeamTiles::countOf(glm::ivec2 quads) {
    const glm::ivec2 tiles = tilesOf(quads);
    return std::int64_t(tiles.x) * tiles.y;
}

std::int64_t BeamTiles::reachedBeams() const {
    std::int64_t beams = 0;
    const int across = tilesOf(quads).x;
    const auto marks = reached.read<std::uint32_t>(std::size_t(count()));
    for (int tile = 0; tile < int(marks.size()); ++tile) {
        if (!marks[std::size_t(tile)]) continue;
        const glm::ivec2 first = tileQuads * glm::ivec2(tile % across, tile / across);
        const glm::ivec2 size = glm::min(quads - first, glm::ivec2(tileQuads));
        beams += 2 * std::int64_t(size.x) * size.y;
    }
    return beams;
}

BeamTilesPass::BeamTilesPass(gl::Context& context)
    : _context(context), _bounds({"caustics/beam_tiles.comp"}) {}

void BeamTilesPass::update(BeamTiles& tiles, const Beams& beams, const WaterMesh& surface) {
    if (tiles.quads != surface.quads) {
        tiles.quads = surface.quads;
        tiles.bounds =
            gl::Buffer(_context.ledger(), "beam tiles", std::int64_t(sizeof(gpu::RayBounds)) * tiles.count());
        tiles.reached = gl::Buffer(_context.ledger(), "beam tiles", 4 * tiles.count());
    }
    tiles.bounds.bindStorage(tileBoundsBuffer);
    tiles.reached.bindStorage(reachedTilesBuffer);
    beams.origins.bindStorage(beamOriginsBuffer);
    beams.directions.bindStorage(beamDirectionsBuffer);
    _bounds.set(quadsLocation, surface.quads);
    _bounds.dispatch(tiles.count(), groupSize);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

BeamCulling::BeamCulling(gl::Context& context)
    : _context(context), _cullPlanes({"caustics/cull_tiles.comp"}),
      _cullLeaning({"caustics/cull_tiles.comp"}, std::array<std::string, 1>{"LEANING"}) {}

void BeamCulling::cull(const BeamTiles& tiles, const LevelMap& map, const gl::Texture& pyramid,
                       Depths depths) {
    assert(tiles.bounds.id() != 0 && pyramid.size() == map.frame.size);
    const std::int64_t bytes = std::int64_t(sizeof(gpu::Kept)) + 4 * tiles.count();
    if (_kept.bytes() < bytes) {
        _kept = {};
        _kept = gl::Buffer(_context.ledger(), "beam tiles", bytes);
    }
    constexpr gpu::Kept none{{0, 0, 1}, 0, 0};
    _kept.write(0, sizeof(none), &none);
    map.box.bindUniform(boxFrameBlock);
    pyramid.bind(depthPyramidUnit);
    tiles.bounds.bindStorage(tileBoundsBuffer);
    tiles.reached.bindStorage(reachedTilesBuffer);
    _kept.bindStorage(keptTilesBuffer);
    const gl::Program& program = depths == Depths::Leaning ? _cullLeaning : _cullPlanes;
    program.set(quadsLocation, tiles.quads);
    program.dispatch(tiles.count(), groupSize);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

void BeamCulling::dispatch(const gl::Program& program, const BeamCulling* culling, glm::ivec2 quads) {
    program.set(culledLocation, culling ? 1 : 0);
    if (!culling) {
        program.dispatch(BeamTiles::countOf(quads) * groupSize, groupSize);
        return;
    }
    culling->_kept.bindStorage(keptTilesBuffer);
    program.dispatchIndirect(culling->_kept, 0);
}

} // namespace limpid
