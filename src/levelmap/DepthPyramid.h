#pragma once
#include "gl/Handles.h"
#include "gl/Program.h"

namespace limpid {

/// Fills the coarser levels of a texture that holds depth ranges: least and greatest depth by blocks of
/// texels, so that a beam learns from a few reads what depths it can meet.
class DepthPyramidPass {
  public:
    DepthPyramidPass();

    /// RGBA32F: of a block the least of x, z and w and the greatest of y. Level 0 is there, written as an
    /// image; after it every level can be fetched.
    void reduce(gl::Texture& pyramid);

  private:
    gl::Program _program;
};

} // namespace limpid
