#include "io/Staging.h"

#include <cerrno>
#include <csignal>
#include <mutex>
#include <set>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace limpid::io {

namespace {

/// Those of the process, as a signal is sent to it and not to one of its parts.
struct Stagings {
    std::mutex mutex;
    std::set<fs::path> paths;
};

Stagings& stagings() {
    static auto& all = *new Stagings; // a signal may come when all else is gone
    return all;
}

int signalsIn = -1; // a handler knows nothing but its signal

void passOn(int signal) {
    const int kept = errno;
    const auto byte = static_cast<unsigned char>(signal);
    [[maybe_unused]] const ssize_t written = ::write(signalsIn, &byte, 1);
    errno = kept;
}

/// What a handler may not do, a thread may.
void awaitSignal(int signalsOut) {
    unsigned char signal = 0;
    while (::read(signalsOut, &signal, 1) != 1) {
    }
    Stagings& all = stagings();
    const std::lock_guard lock(all.mutex); // to the end: nothing else is begun, or gets its name
    for (const fs::path& path : all.paths) {
        // A file that is made meanwhile takes another try; its maker then waits for the lock.
        std::error_code error;
        for (int tries = 0; tries < 3 && (tries == 0 || error); ++tries)
            fs::remove_all(path, error);
    }
    std::signal(signal, SIG_DFL);
    ::kill(::getpid(), signal);
    for (;;)
        ::pause();
}

} // namespace

Staging::Staging(const fs::path& folder) {
    Stagings& all = stagings();
    const std::lock_guard lock(all.mutex);
    std::error_code error;
    // A program of the same number, killed, may have left its own.
    for (int i = 0; _path.empty() && i < 1000; ++i) {
        const fs::path path = (folder.empty() ? fs::path(".") : folder) /
                              fmt::format(".partial-{}{}", ::getpid(), i ? fmt::format("-{}", i) : "");
        if (fs::create_directory(path, error)) _path = path;
        if (error) throw std::system_error(error);
    }
    if (_path.empty()) throw std::system_error(std::make_error_code(std::errc::file_exists));
    all.paths.insert(_path);
}

Staging::~Staging() {
    Stagings& all = stagings();
    const std::lock_guard lock(all.mutex);
    std::error_code ignored;
    fs::remove_all(_path, ignored);
    all.paths.erase(_path);
}

void Staging::whole(const std::function<void()>& moves) {
    const std::lock_guard lock(stagings().mutex);
    moves();
}

void removeStagingsOnSignals() {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) return; // signals end the program as they did
    signalsIn = ends[1];
    std::thread(awaitSignal, ends[0]).detach();
    struct sigaction passing = {};
    passing.sa_handler = passOn;
    passing.sa_flags = SA_RESTART;
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction before = {};
        ::sigaction(signal, nullptr, &before);
        if (before.sa_handler != SIG_IGN) ::sigaction(signal, &passing, nullptr);
    }
}

} // namespace limpid::io
