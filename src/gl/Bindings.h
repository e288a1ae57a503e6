#pragma once

/// Where shaders find what is bound for them: names of uniforms (…Location), textures (…Unit), images,
/// buffers, blocks, attributes and targets, the same as in GLSL.
namespace limpid {
#include "interface/bindings.glsl"

/// Storage buffers that one shader of a stage has at most, which a driver may have fewer of: OpenGL 4.5 asks
/// for 8 in compute and fragment shaders and for none in the others.
constexpr int computeBuffers = 11, fragmentBuffers = 1, vertexBuffers = 3, geometryBuffers = 4;
/// And the places that they are bound to; OpenGL 4.5 asks for 8.
constexpr int bufferBindings = 16;
} // namespace limpid
