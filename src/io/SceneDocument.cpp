#include "io/SceneDocument.h"

#include <sstream>

#include <fmt/format.h>

#include "core/Error.h"
#include "io/DefaultScene.h"
#include "io/Files.h"
#include "io/Gltf.h"
#include "io/SceneOverrides.h"
#include "io/SceneParser.h"
#include "io/SceneSettings.h"
#include "io/TomlPatch.h"
#include "io/TomlReader.h"

namespace fs = std::filesystem;

namespace limpid::io {

struct SceneDocument::Content {
    fs::path file;
    std::string text; ///< of a scene file without overrides; else empty
    toml::table root; ///< with the overrides
    MeshCache meshes;
    Scene scene;
};

namespace {

std::string lowerCaseSuffix(const fs::path& file) {
    std::string suffix = file.extension().string();
    for (char& c : suffix)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return suffix;
}

/// A preset takes the place of the waves that were made for a model alone, unless they are asked for as well.
void dropReplacedWaves(toml::table& root, const std::vector<Override>& overrides) {
    toml::table* water = root["water"].as_table();
    if (!water || !water->contains("preset")) return;
    for (const Override& override : overrides)
        if (override.key.starts_with("water.wave")) return;
    water->erase("wave");
}

template <typename T>
std::string asToml(const T& value) {
    std::ostringstream stream;
    stream << value;
    return stream.str();
}

/// Whether the waves of one have an entry for each of the other's, of the same kind.
bool sameKinds(const std::vector<Wave>& a, const std::vector<Wave>& b) {
    return a.size() == b.size() &&
           std::equal(a.begin(), a.end(), b.begin(), [](const Wave& x, const Wave& y) {
               return x.type == y.type && x.heights == y.heights && x.spectrum == y.spectrum;
           });
}

const toml::array* wavesOf(const toml::table& root) {
    return root["water"]["wave"].as_array();
}

/// The entry of a height map or a sea, of which just the amplitude can have changed.
std::string textureText(const toml::table& root, const Scene& before, const Wave& wave) {
    const toml::array* entries = wavesOf(root);
    for (std::size_t i = 0; entries && i < before.water.waves.size(); ++i) {
        const Wave& known = before.water.waves[i];
        if (known.heights != wave.heights || known.spectrum != wave.spectrum) continue;
        toml::table entry = *entries->get(i)->as_table();
        entry.insert_or_assign("amplitude", wave.amplitude);
        return asToml(entry) + "\n";
    }
    return "";
}

std::string wavesText(const toml::table& root, const Scene& before, const Scene& changed) {
    std::string text;
    for (const Wave& wave : changed.water.waves) {
        text += "[[water.wave]]\n";
        if (isTexture(wave.type)) {
            text += textureText(root, before, wave);
        } else {
            for (const Setting& setting : settingsOf(wave, 0))
                text += fmt::format("{} = {}\n", setting.key, setting.value);
        }
        text += "\n";
    }
    return text;
}

/// What of `settings` is not in `known` with the same value.
std::vector<Setting> difference(const std::vector<Setting>& settings, const std::vector<Setting>& known) {
    std::vector<Setting> result;
    for (const Setting& setting : settings) {
        const bool same = std::any_of(known.begin(), known.end(), [&](const Setting& k) {
            return k.section == setting.section && k.entry == setting.entry && k.key == setting.key &&
                   k.value == setting.value;
        });
        if (!same) result.push_back(setting);
    }
    return result;
}

/// Files that are named relative to `from`, named by their whole path.
std::vector<Setting> wholePaths(const toml::table& root, const fs::path& from) {
    std::vector<Setting> settings;
    const auto add = [&](const toml::array* entries, const char* section, const char* key) {
        for (std::size_t i = 0; entries && i < entries->size(); ++i) {
            const auto name = (*entries->get(i)->as_table())[key].value<std::string>();
            if (!name || fs::path(*name).is_absolute()) continue;
            const std::string whole = fs::weakly_canonical(fs::absolute(from / *name)).string();
            settings.push_back({section, int(i), key, asToml(toml::value<std::string>(whole))});
        }
    };
    add(root["receiver"].as_array(), "receiver", "gltf");
    add(wavesOf(root), "water.wave", "image");
    return settings;
}

void insert(toml::table& root, const Setting& setting) {
    toml::node* node = root.at_path(setting.section).node();
    if (!node && setting.entry < 0)
        node = &root.insert_or_assign(setting.section, toml::table{}).first->second;
    if (node && setting.entry >= 0) node = node->as_array()->get(std::size_t(setting.entry));
    toml::table value = parseToml(fmt::format("value = {}", setting.value), setting.key);
    if (node) node->as_table()->insert_or_assign(setting.key, std::move(value.begin()->second));
}

/// Whether both say the same; a turn may differ by its rounding.
bool agree(const Scene& a, const Scene& b) {
    Scene rounded = a;
    if (a.receivers.size() != b.receivers.size()) return false;
    for (std::size_t i = 0; i < a.receivers.size(); ++i) {
        glm::dquat& turn = rounded.receivers[i].rotation;
        const glm::dquat other = b.receivers[i].rotation;
        if (std::abs(glm::dot(turn, other) - 1) < 1e-12) turn = other;
    }
    const auto one = settingsOf(rounded), two = settingsOf(b);
    return one.size() == two.size() && difference(one, two).empty();
}

} // namespace

SceneDocument::SceneDocument(const fs::path& file, const std::vector<Override>& overrides)
    : _content(std::make_unique<Content>()) {
    requireFile(file);
    const std::string suffix = lowerCaseSuffix(file);
    _content->file = file;
    if (suffix == ".toml") {
        const std::vector<std::uint8_t> bytes = readBytes(file);
        const std::string text(bytes.begin(), bytes.end());
        _content->root = parseToml(text, file.string());
        if (overrides.empty()) _content->text = text;
    } else if (suffix == ".glb" || suffix == ".gltf") {
        Model model = loadModel(file);
        _content->root = defaultScene(file, model);
        _content->meshes[fs::weakly_canonical(file)] = std::make_shared<const Mesh>(std::move(model.mesh));
    } else {
        throw InputError(fmt::format("{}: expected a .toml, .glb or .gltf file, found \"{}\"",
                                     oneLine(file.string()), oneLine(suffix)));
    }
    applyOverrides(_content->root, overrides);
    if (suffix != ".toml") dropReplacedWaves(_content->root, overrides);
    _content->scene = parseScene(_content->root, file, _content->meshes);
}

SceneDocument::~SceneDocument() = default;
SceneDocument::SceneDocument(SceneDocument&&) noexcept = default;
SceneDocument& SceneDocument::operator=(SceneDocument&&) noexcept = default;

const Scene& SceneDocument::scene() const {
    return _content->scene;
}

std::string SceneDocument::textOf(const Scene& changed, const fs::path& folder) const {
    const Content& own = *_content;
    const auto from = fs::absolute(own.file).parent_path();
    const bool moves = fs::weakly_canonical(fs::absolute(folder)) != fs::weakly_canonical(from);
    const bool newWaves = !sameKinds(own.scene.water.waves, changed.water.waves) ||
                          (!wavesOf(own.root) && own.scene.water.waves != changed.water.waves);
    const std::string waves = newWaves ? wavesText(own.root, own.scene, changed) : "";
    std::vector<Setting> settings = difference(settingsOf(changed), settingsOf(own.scene));
    if (newWaves) std::erase_if(settings, [](const Setting& s) { return s.section == "water.wave"; });
    const auto loads = [&](const std::string& text) {
        try {
            MeshCache meshes = own.meshes;
            return agree(changed, parseScene(parseToml(text, "scene"), folder / "scene.toml", meshes));
        } catch (const InputError&) {
            return false;
        }
    };

    if (!own.text.empty()) {
        std::string text = newWaves ? replaceWaves(own.text, own.root, waves) : own.text;
        toml::table root = parseToml(text, "scene");
        if (moves)
            for (Setting& path : wholePaths(root, from))
                settings.push_back(std::move(path));
        text = patchSettings(text, root, settings);
        if (loads(text)) return text;
    }

    toml::table root = own.root;
    if (newWaves) {
        if (!root.contains("water")) root.insert("water", toml::table{});
        root["water"].as_table()->erase("preset");
        root["water"].as_table()->erase("wave");
        toml::table made = parseToml(waves, "scene");
        if (const toml::array* entries = wavesOf(made)) root["water"].as_table()->insert("wave", *entries);
    }
    if (moves)
        for (Setting& path : wholePaths(root, from))
            settings.push_back(std::move(path));
    for (const Setting& setting : settings)
        insert(root, setting);
    const std::string text = asToml(root) + "\n";
    if (!loads(text)) throw InputError("the scene cannot be written as it is");
    return text;
}

} // namespace limpid::io
