#pragma once
#include <cstdint>

#include "core/ShaderData.h"
#include "gl/Api.h"
#include "gl/Bindings.h"
#include "gl/Context.h"
#include "gl/Handles.h"
#include "gl/Program.h"

namespace limpid {

/// Parts of beams that touch many texels, left by one pass to another that gives each a work group
/// (shaders/interface/large_beams.glsl).
class LargeBeams {
  public:
    /// Work groups of one dispatch, which any driver takes: 1 MiB of them.
    static constexpr int mostTiles = 65535;

    /// `tiles`: room for so many, at most mostTiles; what finds none is walked by one invocation.
    explicit LargeBeams(gl::Context& context, int tiles = mostTiles) : _context(context), _tiles(tiles) {}

    /// None is left.
    void clear() {
        constexpr gpu::LargeBeams none{{0, 1, 1}, 0};
        if (!_buffer.id())
            _buffer = gl::Buffer(_context.ledger(), "large beams", std::int64_t(sizeof(none)) + 16 * _tiles);
        _buffer.write(0, sizeof(none), &none);
    }
    void bind() const { _buffer.bindStorage(largeBeamsBuffer); }
    /// A work group for each that was left; waits for the pass that left them.
    void dispatch(const gl::Program& program) const {
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
        program.dispatchIndirect(_buffer, 0);
    }
    /// Gives back its memory until the next clear().
    void free() { _buffer = {}; }

  private:
    gl::Context& _context;
    int _tiles;
    gl::Buffer _buffer;
};

} // namespace limpid
