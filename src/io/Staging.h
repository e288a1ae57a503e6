#pragma once
#include <filesystem>
#include <functional>

namespace limpid::io {

/// A hidden folder for what is being written, inside of the folder that it is to appear in, gone with the
/// object and all that is left in it. Programs that are started to write there find it gone if the user ends
/// this one.
class Staging {
  public:
    /// Throws std::system_error if `folder` takes no other.
    explicit Staging(const std::filesystem::path& folder);
    ~Staging();
    Staging(const Staging&) = delete;
    Staging& operator=(const Staging&) = delete;

    const std::filesystem::path& path() const { return _path; }

    /// Runs `moves`, which gives files their names. A signal comes before it or after it.
    static void whole(const std::function<void()>& moves);

  private:
    std::filesystem::path _path;
};

/// From now on SIGINT, SIGTERM and SIGHUP end the program as they do by default, but not before every Staging
/// is removed. One that is ignored (nohup) stays so. Called once, before the first Staging.
void removeStagingsOnSignals();

} // namespace limpid::io
