#pragma once
#include <cstdlib>
#include <string>

namespace limpid::test {

/// Where models, profiles, shaders and golden pictures lie: the sources, or $LIMPID_ROOT where the tests were
/// unpacked without them.
inline std::string rootFolder() {
    const char* const folder = std::getenv("LIMPID_ROOT");
    return folder ? folder : LIMPID_ROOT;
}

/// Where the program lies, and tests/ with the test programs: the build, or $LIMPID_BUILD.
inline std::string buildFolder() {
    const char* const folder = std::getenv("LIMPID_BUILD");
    return folder ? folder : LIMPID_BUILD;
}

} // namespace limpid::test
