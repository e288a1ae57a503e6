#include "io/SceneFile.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/Error.h"
#include "io/DefaultScene.h"
#include "io/Files.h"
#include "io/Gltf.h"
#include "io/SceneOverrides.h"
#include "io/SceneParser.h"
#include "io/TomlReader.h"

namespace fs = std::filesystem;

namespace limpid::io {

namespace {

std::string lowerCaseSuffix(const fs::path& file) {
    std::string suffix = file.extension().string();
    for (char& c : suffix)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return suffix;
}

toml::table readToml(const fs::path& file) {
    const std::vector<std::uint8_t> bytes = readBytes(file);
    return parseToml({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, file.string());
}

/// A preset takes the place of the waves that were made for a model alone, unless they are asked for as well.
void dropReplacedWaves(toml::table& root, const std::vector<Override>& overrides) {
    toml::table* water = root["water"].as_table();
    if (!water || !water->contains("preset")) return;
    for (const Override& override : overrides)
        if (override.key.starts_with("water.wave")) return;
    water->erase("wave");
}

} // namespace

Scene loadScene(const fs::path& file, const std::vector<Override>& overrides) {
    requireFile(file);
    const std::string suffix = lowerCaseSuffix(file);
    MeshCache meshes;
    toml::table root;
    if (suffix == ".toml") {
        root = readToml(file);
    } else if (suffix == ".glb" || suffix == ".gltf") {
        Model model = loadModel(file);
        root = defaultScene(file, model);
        meshes[fs::weakly_canonical(file)] = std::make_shared<const Mesh>(std::move(model.mesh));
    } else {
        throw InputError(fmt::format("{}: expected a .toml, .glb or .gltf file, found \"{}\"",
                                     oneLine(file.string()), oneLine(suffix)));
    }
    applyOverrides(root, overrides);
    if (suffix != ".toml") dropReplacedWaves(root, overrides);
    return parseScene(root, file, meshes);
}

} // namespace limpid::io
