#pragma once
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include <glm/glm.hpp>

#include "io/toml/SceneDocument.h"

namespace limpid::viewer {

struct Options {
    std::chrono::steady_clock::time_point begin; ///< of the program
    std::filesystem::path file;                  ///< empty: none yet
    /// Loads `file` as the command line asks. Throws InputError.
    std::function<io::SceneDocument()> load;
    glm::ivec2 size{1280, 720}; ///< of the window
    double time = 0;            ///< s
    bool play = false;
    double interfaceScale = 0;        ///< 0: as the display asks for
    std::string panel;                ///< measure, understand or compare; empty: none
    std::string select;               ///< a receiver; empty: none
    std::optional<Method> compare;    ///< a second method
    std::filesystem::path screenshot; ///< empty: none
    int afterFrames = 1;              ///< screenshot: frames with a complete picture before it
    std::int64_t gpuMemory = 0;       ///< bytes; 0: no limit
    bool noSkip = false;
    bool verbose = false;
};

/// Shows the window until it is closed. Wrong files are told in the window. Throws GraphicsError.
void show(const Options& options);

} // namespace limpid::viewer
