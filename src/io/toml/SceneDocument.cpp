#include "io/toml/SceneDocument.h"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>

#include "core/Error.h"
#include "io/Files.h"
#include "io/gltf/Gltf.h"
#include "io/toml/DefaultScene.h"
#include "io/toml/SceneOverrides.h"
#include "io/toml/SceneParser.h"
#include "io/toml/SceneSettings.h"
#include "io/toml/TomlPatch.h"
#include "io/toml/TomlReader.h"
#include "scene/WaterPresets.h"

namespace fs = std::filesystem;

namespace limpid::io {

struct SceneDocument::Content {
    fs::path file;
    std::string text; ///< of a scene file without overrides; else empty
    toml::table root; ///< with the overrides
    MeshCache meshes;
    Scene scene;

    void readScene(const std::vector<Override>& overrides);
    void readModel(const std::vector<Override>& overrides);
};

namespace {

/// The key `without` of the receiver that a model alone becomes. Throws InputError.
NamePatterns withoutOfModel(const toml::table& root, const fs::path& file) {
    const toml::table* receiver = root["receiver"][0].as_table();
    if (!receiver) return {};
    const std::string fileName = file.string();
    TomlTable table(*receiver, fmt::format("receiver.{}", (*receiver)["name"].value_or("0")), fileName);
    return parseWithout(table);
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
               return x.type == y.type && x.heights == y.heights;
           });
}

const toml::array* wavesOf(const toml::table& root) {
    return root["water"]["wave"].as_array();
}

/// The entry of a height map, of which just the amplitude can have changed.
std::string heightMapText(const toml::table& root, const Scene& before, const Wave& wave) {
    const toml::array* entries = wavesOf(root);
    for (std::size_t i = 0; entries && i < before.water.waves.size(); ++i) {
        if (before.water.waves[i].heights != wave.heights) continue;
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
        if (wave.type == WaveType::HeightMap) {
            text += heightMapText(root, before, wave);
        } else {
            for (const Setting& setting : settingsOf(wave, 0))
                text += fmt::format("{} = {}\n", setting.key, setting.value);
        }
        text += "\n";
    }
    return text;
}

bool sameKey(const Setting& a, const Setting& b) {
    return a.section == b.section && a.entry == b.entry && a.key == b.key;
}

/// What makes `before` into `after`.
std::vector<Setting> difference(const std::vector<Setting>& after, const std::vector<Setting>& before) {
    std::vector<Setting> result;
    const auto known = [](const std::vector<Setting>& all, const Setting& one) {
        return std::find_if(all.begin(), all.end(), [&](const Setting& each) { return sameKey(each, one); });
    };
    for (const Setting& setting : after)
        if (const auto old = known(before, setting); old == before.end() || old->value != setting.value)
            result.push_back(setting);
    for (const Setting& setting : before)
        if (known(after, setting) == after.end())
            result.push_back({setting.section, setting.entry, setting.key, ""});
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
    if (!node) return;
    if (setting.value.empty()) {
        node->as_table()->erase(setting.key);
        return;
    }
    toml::table value = parseToml(fmt::format("value = {}", setting.value), setting.key);
    node->as_table()->insert_or_assign(setting.key, std::move(value.begin()->second));
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
    return difference(settingsOf(rounded), settingsOf(b)).empty();
}

/// What a document's scene has to become another.
struct Changes {
    std::vector<Setting> settings;
    /// In place of all waves there are; none: they stay, but for the settings. A preset's are none.
    std::optional<std::string> waves;
    std::optional<fs::path> movedFrom; ///< the folder that files are named relative to
};

/// The preset that makes the water's waves as they are.
std::optional<std::size_t> presetOf(const Water& water) {
    for (std::size_t i = 0; i < std::size(waterPresets); ++i)
        if (water.waves == presetWaves(i, water.center.value_or(glm::dvec2(0)))) return i;
    return std::nullopt;
}

/// Each amplitude by itself, in place of `wave_scale`.
void unscaleWaves(std::vector<Setting>& settings, const Water& water) {
    std::erase_if(settings,
                  [](const Setting& s) { return s.section == "water.wave" && s.key == "amplitude"; });
    for (std::size_t i = 0; i < water.waves.size(); ++i)
        for (const Setting& setting : settingsOf(water.waves[i], int(i)))
            if (setting.key == "amplitude") settings.push_back(setting);
    settings.push_back({"water", -1, "wave_scale", ""});
}

Changes changesOf(const toml::table& root, const Scene& before, const Scene& changed) {
    Changes changes{difference(settingsOf(changed), settingsOf(before)), std::nullopt, std::nullopt};
    const Water &old = before.water, &water = changed.water;
    const bool otherWaves = old.waves != water.waves;
    // A preset's waves may follow the water's center.
    const bool unlisted = !wavesOf(root) && (otherWaves || old.center != water.center);
    if ((otherWaves || unlisted) && root["water"]["wave_scale"]) unscaleWaves(changes.settings, water);
    if (sameKinds(old.waves, water.waves) && !unlisted) return changes;
    std::erase_if(changes.settings, [](const Setting& s) { return s.section == "water.wave"; });
    const auto preset = presetOf(water);
    changes.waves = preset ? "" : wavesText(root, before, changed);
    if (preset)
        changes.settings.push_back({"water", -1, "preset", fmt::format("\"{}\"", waterPresets[*preset])});
    return changes;
}

/// What is to be set in `root`, which has its waves already.
std::vector<Setting> settingsFor(const toml::table& root, const Changes& changes) {
    std::vector<Setting> settings = changes.settings;
    if (changes.movedFrom)
        for (Setting& path : wholePaths(root, *changes.movedFrom))
            settings.push_back(std::move(path));
    return settings;
}

/// The text with the changes in place.
std::string patched(std::string text, const toml::table& root, const Changes& changes) {
    if (changes.waves) text = replaceWaves(text, root, *changes.waves);
    const toml::table replaced = parseToml(text, "scene");
    return patchSettings(text, replaced, settingsFor(replaced, changes));
}

/// The scene written anew.
std::string rewritten(toml::table root, const Changes& changes) {
    if (changes.waves) {
        if (!root.contains("water")) root.insert("water", toml::table{});
        toml::table& water = *root["water"].as_table();
        water.erase("preset");
        water.erase("wave");
        toml::table made = parseToml(*changes.waves, "scene");
        if (const toml::array* entries = wavesOf(made)) water.insert("wave", *entries);
    }
    for (const Setting& setting : settingsFor(root, changes))
        insert(root, setting);
    return asToml(root) + "\n";
}

} // namespace

bool isModelFile(const fs::path& file) {
    const std::string suffix = lowerCaseSuffix(file);
    return suffix == ".glb" || suffix == ".gltf";
}

Override leavingOut(const std::vector<std::string>& patterns) {
    toml::array list;
    for (const std::string& pattern : patterns)
        list.push_back(pattern);
    return {"receiver.0.without", asToml(list)};
}

void SceneDocument::Content::readScene(const std::vector<Override>& overrides) {
    const std::vector<std::uint8_t> bytes = readBytes(file);
    const std::string all(bytes.begin(), bytes.end());
    root = parseToml(all, file.string());
    if (overrides.empty()) text = all;
    applyOverrides(root, overrides);
}

/// A model alone. What it is to go without has no say in the scene that is made for it.
void SceneDocument::Content::readModel(const std::vector<Override>& overrides) {
    const auto read = [&](const NamePatterns& without) {
        Model model = loadModel(file, without);
        root = defaultScene(file, model);
        for (std::string& notice : unusedViews(file, model, root))
            model.mesh.notices.push_back(std::move(notice));
        applyOverrides(root, overrides);
        meshes[{fs::weakly_canonical(file), without}] = std::make_shared<const Mesh>(std::move(model.mesh));
    };
    read({});
    if (const NamePatterns without = withoutOfModel(root, file); !without.empty()) read(without);
    dropReplacedWaves(root, overrides);
}

SceneDocument::SceneDocument(const fs::path& file, const std::vector<Override>& overrides)
    : _content(std::make_unique<Content>()) {
    requireFile(file);
    _content->file = file;
    if (isModelFile(file))
        _content->readModel(overrides);
    else if (const std::string suffix = lowerCaseSuffix(file); suffix == ".toml")
        _content->readScene(overrides);
    else
        throw InputError(fmt::format("{}: expected a .toml, .glb or .gltf file, found \"{}\"",
                                     oneLine(file.string()), oneLine(suffix)));
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
    Changes changes = changesOf(own.root, own.scene, changed);
    if (fs::weakly_canonical(fs::absolute(folder)) != fs::weakly_canonical(from)) changes.movedFrom = from;
    const auto loads = [&](const std::string& text) {
        try {
            MeshCache meshes = own.meshes;
            return agree(changed, parseScene(parseToml(text, "scene"), folder / "scene.toml", meshes));
        } catch (const InputError&) {
            return false;
        }
    };
    if (!own.text.empty())
        if (std::string text = patched(own.text, own.root, changes); loads(text)) return text;
    if (std::string text = rewritten(own.root, changes); loads(text)) return text;
    throw InputError("the scene cannot be written as it is");
}

} // namespace limpid::io
