#include "core/Progress.h"

#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

namespace limpid {

Progress::Progress(std::string what, int total, bool enabled)
    : _what(std::move(what)), _total(total), _shown(enabled && isatty(STDERR_FILENO) != 0),
      _start(std::chrono::steady_clock::now()) {}

Progress::~Progress() {
    if (_shown) fmt::print(stderr, "\r\x1b[K");
}

std::string Progress::text(const std::string& what, int done, int total, double seconds) {
    if (done <= 0) return fmt::format("{} {}/{}", what, done, total);
    const int left = int(seconds / done * (total - done) + 0.5);
    return fmt::format("{} {}/{}, {}:{:02} left", what, done, total, left / 60, left % 60);
}

void Progress::update(int done) {
    if (!_shown) return;
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - _start;
    fmt::print(stderr, "\r\x1b[K{}", text(_what, done, _total, passed.count()));
    std::fflush(stderr);
}

} // namespace limpid
