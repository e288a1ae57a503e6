#pragma once
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "io/bake/BakedFolder.h"
#include "io/toml/SceneDocument.h"

namespace limpid::apps {

/// What every command that works on a scene takes.
struct CommonOptions {
    std::string input;
    std::string method;
    std::string fill;
    std::string godrays;
    std::optional<int> planes;
    std::optional<int> mapSize;
    std::vector<std::string> settings; ///< KEY=VALUE
    std::vector<std::string> without;  ///< patterns of names, for a model alone
    bool noSkip = false;
    std::string device;
    double gpuMemory = 0; ///< MiB; 0: no limit
    bool quiet = false;
    bool verbose = false;
};

void addCommonOptions(CLI::App& command, CommonOptions& options);

/// The scene with everything that the command line says about it. Throws InputError.
Scene loadScene(const CommonOptions& options);
io::SceneDocument loadDocument(const CommonOptions& options); ///< the same, to be written again

/// Throws InputError unless `seconds` is a number that a scene can be at.
void requireTime(double seconds);

/// "WxH" in pixels. Throws InputError.
glm::ivec2 parseSize(const std::string& text);

/// Whether a program of that name is on the path.
bool onPath(const std::string& program);

/// Ends the program with `code` after it has said why.
struct Exit {
    int code = 0;
};

/// Where each light went, on stdout.
void printFlux(const io::Bake& bake);

void addRender(CLI::App& app);
void addBake(CLI::App& app);
void addCompare(CLI::App& app);
void addProfile(CLI::App& app);
void addInfo(CLI::App& app);
void addShell(CLI::App& app);     ///< completion and manual page
void addReference(CLI::App& app); ///< in builds with LIMPID_REFERENCE
void addView(CLI::App& app);      ///< in builds without LIMPID_VIEWER it says that there is none

} // namespace limpid::apps
