#pragma once
#include "gl/Context.h"
#include "scene/Scene.h"

namespace limpid {

/// Of quads of the water.
bool hasRoomFor(glm::ivec2 grid, const gl::DeviceInfo& gpu);

/// Throw InputError where a scene asks for more than the GPU has room for.
void requireGrid(glm::ivec2 grid, const gl::DeviceInfo& gpu);
void requirePlanes(const CausticsSettings& settings, const gl::DeviceInfo& gpu);

} // namespace limpid
