#pragma once
#include <initializer_list>

#include <epoxy/gl.h>

/// A linked program of shader files beside this one; .vert, .frag and .comp say the stage, and `#include
/// "limpid_caustics.glsl"` brings the file that Limpid installs. Throws std::runtime_error with the driver's
/// words.
GLuint makeProgram(std::initializer_list<const char*> files);
