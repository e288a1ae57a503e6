#pragma once
#include <cstdint>

#include "gl/Context.h"
#include "gl/Handles.h"
#include "gl/Program.h"

namespace limpid {

/// Quads that one pass leaves to others (shaders/interface/beam_lists.glsl): narrow ones, of which each
/// invocation takes one, and broad ones, each for as many work groups as keep an invocation's way short.
/// There is room for all quads in every list.
class BeamLists {
  public:
    explicit BeamLists(gl::Context& context) : _context(context) {}

    /// Empties all: of the `quads` of the water's grid, and of a map of so many texels. What wrote them
    /// before is done with.
    void clear(std::int64_t quads, std::int64_t texels);
    void bind() const;
    /// Work for all in a list, by its number in the shaders.
    void dispatch(const gl::Program& program, int list) const;
    /// Gives back its memory until the next clear().
    void free() { _buffer = {}; }

  private:
    gl::Context& _context;
    gl::Buffer _buffer;
};

} // namespace limpid
