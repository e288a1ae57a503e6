#pragma once
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace limpid::fuzz {

/// Ends the run, so that the fuzzer keeps what led here.
inline void require(bool good, const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    if (good) return;
    std::fprintf(stderr, "%s:%d: not as it must be\n", file, line);
    std::abort();
}

/// What an error says to the user.
inline void requireOneLine(std::string_view error, const char* file = __builtin_FILE(),
                           int line = __builtin_LINE()) {
    require(!error.empty() && error.size() < 2000 && error.find('\n') == error.npos, file, line);
}

} // namespace limpid::fuzz
