#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "io/toml/SceneFile.h"
#include "scene/Scene.h"

namespace limpid::io {

/// A receiver that takes the place of the scene's own.
struct ProfileReceiver {
    std::string name;
    std::string toml;   ///< the value of the scene's key `receiver`
    bool model = false; ///< to be brought to 1 m of length, standing on y = 0 in the middle
};

/// Numbers that others printed, to be drawn beside ours: one column for a receiver and a method.
struct PrintedTable {
    struct Column {
        std::string receiver, method;
        std::vector<double> values; ///< by row
    };
    std::vector<int> planes; ///< of each row
    std::vector<Column> columns;
};

/// What to measure. Lists combine; an empty one leaves the matter to the scene.
struct Profile {
    std::string name; ///< of the file, without folder and suffix
    std::vector<std::filesystem::path> scenes;
    std::vector<ProfileReceiver> receivers;
    std::vector<Method> methods;
    std::vector<Fill> fills; ///< of methods that have them
    std::vector<int> planes, mapSizes;
    std::vector<glm::ivec2> grids;
    std::vector<std::string> godrays;    ///< values of the scene's key `godrays`, each measured by itself
    std::vector<Override> settings;      ///< of every scene
    int warmup = 1;                      ///< untimed updates before each timed frame
    int frames = 5;                      ///< timed ones of each combination
    std::int64_t reference = 0;          ///< photons of the ground truth; 0: no error figures
    bool reuse = false;                  ///< whether a timed frame may reuse what the one before it made
    std::optional<Method> baseline;      ///< every map is compared with this method's
    double time = 0;                     ///< s
    glm::ivec2 picture{320, 180};        ///< pixels of a frame's picture
    std::optional<PrintedTable> seconds; ///< printed run times, s
    std::optional<PrintedTable> actualPlanes; ///< printed numbers of planes after smart slicing
};

/// Reads a profile. Relative paths start at its folder; a folder among `receivers` stands for every .glb in
/// it, in the order of their names. Throws InputError.
Profile loadProfile(const std::filesystem::path& file);

/// A model, or a folder of them, as receivers. Throws InputError if there is none.
std::vector<ProfileReceiver> modelReceivers(const std::filesystem::path& modelOrFolder);

/// A table of tab-separated numbers; `#` begins a comment. The first line names the columns: `planes`, then
/// `RECEIVER METHOD` each. Throws InputError.
PrintedTable loadPrintedTable(const std::filesystem::path& file);

} // namespace limpid::io
