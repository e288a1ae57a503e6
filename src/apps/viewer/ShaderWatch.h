#pragma once
#include <chrono>
#include <filesystem>

namespace limpid::viewer {

/// Notices when a file in the folder of LIMPID_SHADERS (gl/ShaderLibrary.h) changes; without one, never.
class ShaderWatch {
  public:
    ShaderWatch();
    /// Whether one changed since the last call that said so. Looks twice a second at most.
    bool changed();

  private:
    std::filesystem::file_time_type newest() const;
    std::filesystem::path _folder;
    std::filesystem::file_time_type _known;
    std::chrono::steady_clock::time_point _looked;
};

} // namespace limpid::viewer
