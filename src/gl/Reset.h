#pragma once
#include "core/Error.h"

namespace limpid::gl {

/// The driver has reset the GPU, and all that was on it is gone: nothing more can be drawn in this process.
class ContextLost : public GraphicsError {
  public:
    using GraphicsError::GraphicsError;
};

/// Throws ContextLost if the driver has reset the GPU since the context was made. What is read from the GPU
/// is to be trusted only if this is asked after it, as Buffer and Texture do.
void requireContext();

} // namespace limpid::gl
