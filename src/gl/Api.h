#pragma once
/// The OpenGL entry points, as everybody outside of gl/ gets them.
#include <epoxy/gl.h>
