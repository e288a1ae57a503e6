#include "caustics/BeamFootprints.h"

#include <array>
#include <string>

#include "gl/Bindings.h"

namespace limpid {

namespace {
constexpr int groupSize = 64;
} // namespace

BeamFootprints::BeamFootprints(gl::Context& context)
    : _context(context), _rays({"caustics/footprints.comp"}),
      _tileRays({"caustics/footprints.comp"}, std::array<std::string, 1>{"TILES"}),
      _area({"caustics/footprint_areas.comp"}) {}

void BeamFootprints::resize(const Beams& beams, const WaterMesh& surface) {
    if (beams.vertexCount != _vertexCount || beams.triangleCount != _triangleCount) {
        gl::Ledger& ledger = _context.ledger();
        _vertexCount = beams.vertexCount;
        _triangleCount = beams.triangleCount;
        _footprints = gl::Buffer(ledger, "beam footprints", std::int64_t(_vertexCount) * 16);
        _originDepths = gl::Buffer(ledger, "beam footprints", std::int64_t(_vertexCount) * 4);
        _areas = gl::Buffer(ledger, "beam footprints", std::int64_t(_triangleCount) * 16);
        _vertexArray.attribute(footprintAttribute, _footprints, 4, 0, 16);
        _vertexArray.attribute(originDepthAttribute, _originDepths, 1, 0, 4);
    }
    _vertexArray.indices(surface.indices);
}

void BeamFootprints::free() {
    _footprints = {};
    _originDepths = {};
    _areas = {};
    _vertexCount = _triangleCount = 0;
}

void BeamFootprints::updateRays(const Beams& beams, const WaterMesh& surface, const LevelMap& map,
                                const BeamCulling* culling) {
    resize(beams, surface);
    map.box.bindUniform(boxFrameBlock);
    beams.origins.bindStorage(beamOriginsBuffer);
    beams.directions.bindStorage(beamDirectionsBuffer);
    _footprints.bindStorage(footprintsBuffer);
    _originDepths.bindStorage(originDepthsBuffer);
    if (culling) {
        _tileRays.set(quadsLocation, surface.quads);
        BeamCulling::dispatch(_tileRays, culling, surface.quads);
    } else {
        _rays.set(vertexCountLocation, _vertexCount);
        _rays.dispatch(_vertexCount, groupSize);
    }
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void BeamFootprints::update(const Beams& beams, const WaterMesh& surface, const LevelMap& map) {
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT |
                    GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT); // draws of the map before
    updateRays(beams, surface, map);
    surface.indices.bindStorage(indicesBuffer);
    beams.flux.bindStorage(beamFluxBuffer);
    _areas.bindStorage(beamAreasBuffer);
    _area.set(triangleCountLocation, _triangleCount);
    _area.dispatch(_triangleCount, groupSize);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT);
}

} // namespace limpid
