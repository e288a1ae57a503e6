#include "caustics/BeamLists.h"

#include <algorithm>

#include "core/ShaderData.h"
#include "gl/Bindings.h"

namespace limpid {

namespace {

/// Work groups that share a broad quad: so many that none of their 64 invocations walks more than some 256
/// texels. Of light along a receiver one quad may walk a tenth of its map, however many quads there are.
std::uint32_t partsFor(std::int64_t quads, std::int64_t texels) {
    constexpr std::int64_t share = 128, mostQuads = 1024, mostParts = 64;
    const std::int64_t whole = std::min(quads, mostQuads) * share;
    return std::uint32_t(std::clamp<std::int64_t>((texels + whole - 1) / whole, 1, mostParts));
}

} // namespace

void BeamLists::clear(std::int64_t quads, std::int64_t texels) {
    const std::uint32_t parts = partsFor(quads, texels);
    const glm::uvec4 narrow{0, 1, 1, 0}, broad{0, parts, 1, 0};
    const gpu::BeamLists none{{narrow, narrow, broad, broad, narrow}};
    const std::int64_t bytes = std::int64_t(sizeof(none)) + 4 * (gpu::left + parts) * quads;
    if (_buffer.bytes() != bytes) _buffer = gl::Buffer(_context.ledger(), "beam lists", bytes);
    _buffer.write(0, sizeof(none), &none);
}

void BeamLists::bind() const {
    _buffer.bindStorage(beamListsBuffer);
}

void BeamLists::dispatch(const gl::Program& program, int list) const {
    program.dispatchIndirect(_buffer, std::int64_t(list) * std::int64_t(sizeof(glm::uvec4)));
}

} // namespace limpid
