#include "engine/Limits.h"

#include <fmt/format.h>

#include "core/Error.h"
#include "scene/MethodFacts.h"

namespace limpid {

namespace {

/// The largest buffer holds 16 bytes a triangle.
std::int64_t mostQuads(const gl::DeviceInfo& gpu) {
    return gpu.maxStorageBlockBytes / 32;
}

} // namespace

bool hasRoomFor(glm::ivec2 grid, const gl::DeviceInfo& gpu) {
    return std::int64_t(grid.x) * grid.y <= mostQuads(gpu);
}

void requireGrid(glm::ivec2 grid, const gl::DeviceInfo& gpu) {
    if (!hasRoomFor(grid, gpu))
        throw InputError(
            fmt::format("water.grid: expected at most {} quads in all with this GPU, found {} x {}",
                        mostQuads(gpu), grid.x, grid.y));
}

void requirePlanes(const CausticsSettings& settings, const gl::DeviceInfo& gpu) {
    if (factsOf(settings.method).sliceImages && settings.planes > gpu.maxTextureLayers)
        throw InputError(
            fmt::format("caustics.planes: expected at most {} with this GPU and method {}, found {}",
                        gpu.maxTextureLayers, methodName(settings.method), settings.planes));
}

} // namespace limpid
