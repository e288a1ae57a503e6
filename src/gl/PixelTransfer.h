#pragma once
#include <array>

#include "gl/Api.h"

namespace limpid::gl {

/// While it lives, pixels go to and from memory one right after the other, whatever a host has set; then that
/// is back.
class PixelTransfer {
  public:
    PixelTransfer();
    ~PixelTransfer();
    PixelTransfer(const PixelTransfer&) = delete;
    PixelTransfer& operator=(const PixelTransfer&) = delete;

  private:
    std::array<GLint, 16> _stores{};
    GLint _packBuffer = 0, _unpackBuffer = 0;
};

} // namespace limpid::gl
