#include "caustics/FluxSums.h"

namespace limpid {

namespace {
constexpr GLuint binding = 8;
}

void FluxSums::bind(std::int64_t count) {
    const std::int64_t bytes = 8 * count;
    if (_sums.bytes() < bytes) {
        _sums = {}; // free before more is asked for
        _sums = gl::Buffer(_context.ledger(), "flux sums", bytes);
        _sums.clearToZero();
    }
    _sums.bindStorage(binding);
}

} // namespace limpid
