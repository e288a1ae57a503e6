#include "caustics/BeamFootprints.h"

#include <array>
#include <string>

namespace limpid {

namespace {
constexpr int groupSize = 64;
enum Uniform { Count, Quads = 0 };
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
        _vertexArray.attribute(0, _footprints, 4, 0, 16);
        _vertexArray.attribute(1, _originDepths, 1, 0, 4);
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
    map.box.bindUniform(1);
    beams.origins.bindStorage(3);
    beams.directions.bindStorage(4);
    _footprints.bindStorage(6);
    _originDepths.bindStorage(7);
    if (culling) {
        _tileRays.set(Quads, surface.quads);
        BeamCulling::dispatch(_tileRays, culling, surface.quads);
    } else {
        _rays.set(Count, _vertexCount);
        _rays.dispatch(_vertexCount, groupSize);
    }
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void BeamFootprints::update(const Beams& beams, const WaterMesh& surface, const LevelMap& map) {
    updateRays(beams, surface, map);
    surface.indices.bindStorage(0);
    beams.flux.bindStorage(5);
    _areas.bindStorage(8);
    _area.set(Count, _triangleCount);
    _area.dispatch(_triangleCount, groupSize);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT);
}

} // namespace limpid
