#pragma once

/// Where shaders find what is bound for them: names of uniforms (…Location), textures (…Unit), images,
/// buffers, blocks, attributes and targets, the same as in GLSL.
namespace limpid {
#include "interface/bindings.glsl"
} // namespace limpid
