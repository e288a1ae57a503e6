#pragma once
#include <string>
#include <vector>

#include "scene/Scene.h"

namespace limpid::io {

/// One key of a scene file and its value.
struct Setting {
    std::string section; ///< the table's dotted key: "camera", "light", "water.wave"
    int entry = -1;      ///< of an array of tables; -1: the section is a plain table
    std::string key;
    std::string value; ///< as TOML; empty: the key is to go
};

/// Every key that a scene's plain data say; shapes, files and names of the entries are not among them.
/// Numbers come back from a file as they are here. Water that is one of the named bodies
/// (scene/WaterBodies.h) gives its name in place of what that stands for. Waves of height maps give their
/// amplitude alone.
std::vector<Setting> settingsOf(const Scene& scene);

/// The entry of a wave, but for height maps: key by key.
std::vector<Setting> settingsOf(const Wave& wave, int entry);

} // namespace limpid::io
