#pragma once
#include <stdexcept>
#include <string>

namespace limpid {

/// What the user gave cannot be used: a file, a key, an option. The program ends with exit code 2.
/// `what()` is one line: file, place, what was expected, what was found.
class InputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The graphics system cannot do what is needed: no EGL, no OpenGL 4.5, a shader that does not compile,
/// memory that is not there. The program ends with exit code 3.
class GraphicsError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

} // namespace limpid
