// How blocks are written that C++ reads too (core/ShaderData.h), which makes each of them a struct: a block of uniforms, a
// block of storage, and its last member, an array without end, which a struct leaves out. Vectors of four, or a scalar
// behind each of three, lie alike in both languages.
#pragma once
#ifdef GLSL
#include "interface/bindings.glsl"
#define UNIFORM_BLOCK(name, at) layout(std140, binding = at) uniform name
#define STORAGE_BLOCK(name, at) layout(std430, binding = at) buffer name
#define ENDLESS(type, name) type name[];
#else
#define UNIFORM_BLOCK(name, at) struct name
#define STORAGE_BLOCK(name, at) struct name
#define ENDLESS(type, name)
#endif
