#include "engine/Limits.h"

#include <fmt/format.h>

#include "core/Error.h"

namespace limpid {

/// The largest buffer holds 16 bytes a triangle.
void requireGrid(glm::ivec2 grid, const gl::DeviceInfo& gpu) {
    const std::int64_t triangles = 2 * std::int64_t(grid.x) * grid.y, most = gpu.maxStorageBlockBytes / 16;
    if (triangles > most)
        throw InputError(
            fmt::format("water.grid: expected at most {} quads in all with this GPU, found {} x {}", most / 2,
                        grid.x, grid.y));
}

void requirePlanes(const CausticsSettings& settings, const gl::DeviceInfo& gpu) {
    if (settings.method == Method::Volumetric && settings.planes > gpu.maxTextureLayers)
        throw InputError(
            fmt::format("caustics.planes: expected at most {} with this GPU and method volumetric, found {}",
                        gpu.maxTextureLayers, settings.planes));
}

} // namespace limpid
