// One table says every key: the parser takes these and no others, with the defaults and ranges that it names,
// and the pages that are committed say the same. LIMPID_WRITE=1 writes these pages anew.
#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Folders.h"
#include "io/SmallGltf.h"
#include "io/TempFolder.h"
#include "io/toml/SceneFile.h"
#include "io/toml/SceneSettings.h"
#include "scene/Keys.h"

namespace limpid::io {
namespace {

using test::errorOf;
using test::TempFolder;
using testing::HasSubstr;
using testing::Not;
using Strings = std::set<std::string>;

/// Each entry is of another kind, so that every key counts somewhere. The height map's file is missing.
constexpr const char* text = R"(
[[water.wave]]
type = "cosine"
[[water.wave]]
type = "circular"
[[water.wave]]
type = "noise"
[[water.wave]]
type = "phillips"
modes = 16
[[light]]
name = "sun"
[[light]]
type = "point"
position = [0, 1, 0]
[[light]]
type = "spot"
position = [0, 1, 0]
[[receiver]]
plane = { size = [2, 2] }
[[receiver]]
sphere = { radius = 1 }
[[receiver]]
box = { size = [1, 1, 1] }
[[receiver]]
gltf = "fish.gltf"
)";
constexpr std::size_t entries = 5;

class SceneKeysTest : public testing::Test {
  protected:
    SceneKeysTest() {
        folder.write("fish.gltf", test::triangleGltf().text());
        file = folder.write("scene.toml", text);
    }
    std::string errorWith(const std::string& key, const std::string& value) const {
        return errorOf(folder, [&] { loadScene(file, {{key, value}}); });
    }

    TempFolder folder;
    std::filesystem::path file;
};

/// The keys that a reading of `path` knows, by what its error for an unknown one lists.
Strings knownIn(const std::string& error, const std::string& section) {
    const std::string_view before = "expected one of ";
    Strings keys;
    const std::size_t at = error.find(before);
    if (at == std::string::npos) return keys;
    std::istringstream list(error.substr(at + before.size()));
    for (std::string key; std::getline(list >> std::ws, key, ',');)
        keys.insert(section + '.' + key);
    return keys;
}

TEST_F(SceneKeysTest, theParserTakesTheKeysOfTheTable) {
    Strings told, taken;
    for (const KeyFacts& key : sceneKeys()) {
        EXPECT_TRUE(told.insert(fmt::format("{}.{}", key.section, key.name)).second) << key.path();
        const std::string section(key.section);
        for (std::size_t i = 0; i < (key.listed ? entries : 1); ++i) {
            const std::string entry = key.listed ? fmt::format("{}.{}", section, i) : section;
            taken.merge(knownIn(errorWith(entry + ".no_such_key", "1"), section));
        }
    }
    // A height map's file is asked for last, so its keys are listed before.
    taken.merge(knownIn(errorOf(folder,
                                [&] {
                                    loadScene(file, {{"water.wave", "[{ type = \"heightmap\", image = \"x\", "
                                                                    "placement = [0, 0, 1, 1], no = 1 }]"}});
                                }),
                        "water.wave"));
    for (const auto& [receiver, shape] :
         {std::pair(0, "plane"), std::pair(1, "sphere"), std::pair(2, "box")}) {
        taken.merge(knownIn(errorWith(fmt::format("receiver.{}.{}.no_such_key", receiver, shape), "1"),
                            fmt::format("receiver.{}", shape)));
        taken.erase(fmt::format("receiver.{}", shape));
    }
    taken.erase("water.wave"); // a section
    EXPECT_EQ(told, taken);
}

/// The entry in which the key counts; none for those of height maps.
std::optional<std::size_t> entryFor(const KeyFacts& key, const Scene& scene) {
    if (key.name.starts_with("sphere")) return 1;
    if (key.name.starts_with("box")) return 2;
    if (key.name == "gltf" || key.name == "without") return 3;
    for (std::size_t i = 0; i < entries; ++i)
        if (!key.present(scene, i).empty() || !key.another(scene, i).empty()) return i;
    return std::nullopt;
}

bool same(const Scene& a, const Scene& b) {
    const auto one = settingsOf(a), two = settingsOf(b);
    bool all = one.size() == two.size();
    for (std::size_t i = 0; all && i < one.size(); ++i)
        all = one[i].key == two[i].key && one[i].value == two[i].value;
    for (std::size_t i = 0; all && i < a.receivers.size(); ++i)
        all = a.receivers[i].name == b.receivers[i].name &&
              a.receivers[i].mesh->positions == b.receivers[i].mesh->positions &&
              a.receivers[i].mesh->materials[0].baseColor == b.receivers[i].mesh->materials[0].baseColor;
    for (std::size_t i = 0; all && i < a.lights.size(); ++i)
        all = a.lights[i].name == b.lights[i].name;
    return all;
}

TEST_F(SceneKeysTest, defaultsAreAsTheTableSays) {
    const Override shafts{"godrays.method", "exact-shafts"}; // none in a table without it
    const Scene scene = loadScene(file, {shafts});
    for (const KeyFacts& key : sceneKeys()) {
        const auto entry = entryFor(key, scene);
        if (key.standard.starts_with('(') || key.name == "modes" || !entry) continue;
        EXPECT_TRUE(same(scene, loadScene(file, {shafts, {key.path(*entry), key.standard}})))
            << key.path(*entry) << ' ' << key.standard;
    }
}

TEST_F(SceneKeysTest, anotherValueOfEachKeyChangesTheScene) {
    std::size_t changed = 0;
    for (const char* method : {"photon-splat", "level-map-smart"})
        for (const char* godrays : {"none", "photon-lines", "exact-shafts", "tetrahedra"}) {
            const std::vector<Override> both = {
                {"caustics.method", method}, {"caustics.slicing", "levels"}, {"godrays.method", godrays}};
            const Scene scene = loadScene(file, both);
            for (const KeyFacts& key : sceneKeys()) {
                const auto entry = entryFor(key, scene);
                const std::string another = entry ? key.another(scene, *entry) : "";
                if (another.empty() || key.name == "type") continue; // of waves: other keys come with it
                std::vector<Override> overrides = both;
                overrides.push_back({key.path(*entry), another});
                EXPECT_FALSE(same(scene, loadScene(file, overrides))) << key.path(*entry) << ' ' << another;
                ++changed;
            }
        }
    EXPECT_GT(changed, 4 * sceneKeys().size());
}

TEST_F(SceneKeysTest, everyRowIsWhole) {
    for (const KeyFacts& key : sceneKeys()) {
        EXPECT_FALSE(key.says.empty() || key.expected.empty() || key.standard.empty()) << key.path();
        EXPECT_THAT(sentenceOf(key), Not(HasSubstr("\n")));
    }
}

// Pages that are made from the table.

/// The parts of a key's name, as a file has them.
void addParts(Strings& words, std::string_view name) {
    std::istringstream parts{std::string(name)};
    for (std::string part; std::getline(parts, part, '.');)
        words.insert(part);
}

std::string headerOf(const KeyFacts& key) {
    return key.listed ? fmt::format("[[{}]]", key.section) : fmt::format("[{}]", key.section);
}

/// For libFuzzer: keys, sections, names, and what else scene files are made of.
std::string dictionary() {
    Strings words, headers, names;
    for (const KeyFacts& key : sceneKeys()) {
        addParts(words, key.section);
        addParts(words, key.name);
        headers.insert(headerOf(key));
        if (const Choice* choice = std::get_if<Choice>(&key.takes))
            names.insert(choice->names.begin(), choice->names.end());
    }
    std::string page;
    for (const std::string& word : words)
        page += fmt::format("\"{}\"\n", word);
    for (const std::string& header : headers)
        page += fmt::format("\"{}\\x0a\"\n", header);
    for (const std::string& name : names)
        page += fmt::format("\"\\\"{}\\\"\"\n", name);
    return page + R"("[["
"]]"
"1e12"
"-1e308"
"inf"
"nan"
"{ size = [1, 1] }"
"{ radius = 0.1 }"
"{ size = [1, 1, 1] }"
"[0, 0, 0]"
"\"\"\""
"'''"
"\\u0000"
"\x00light.sun.direction=[0,-1,0]"
"\x00water.wave.0.amplitude=1"
"%04d"
)";
}

std::string markdown() {
    std::string page = R"(# Scene keys

Every key of a scene file and of `--set`; `limpid man` says the same. Made from the table in
[`src/scene/KeyTable.cpp`](../src/scene/KeyTable.cpp) by `LIMPID_WRITE=1 build/tests/SceneKeysTest`. All numbers are finite
and at most 10¹² in size, colours are linear RGB. `[[…]]` is one of several. A key of another `type` is an error, one for
other methods rests.
)";
    std::string_view section;
    for (const KeyFacts& key : sceneKeys()) {
        if (key.section != section)
            page += fmt::format("\n## `{}`\n| key | default | unit | takes | says | for |\n"
                                "| --- | --- | --- | --- | --- | --- |\n",
                                headerOf(key));
        section = key.section;
        const std::string standard = key.standard.starts_with('(')
                                         ? key.standard.substr(1, key.standard.size() - 2)
                                         : fmt::format("`{}`", key.standard);
        page += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", key.name, standard, key.unit, key.expected,
                            key.says, key.when);
    }
    return page;
}

void expectPage(const char* name, const std::string& page) {
    const std::filesystem::path file = std::filesystem::path(test::rootFolder()) / name;
    if (std::getenv("LIMPID_WRITE")) std::ofstream(file) << page;
    std::stringstream committed;
    committed << std::ifstream(file).rdbuf();
    EXPECT_TRUE(committed.str() == page) << name << " is not what the table of keys makes of it; "
                                         << "LIMPID_WRITE=1 build/tests/SceneKeysTest writes it";
}

TEST(SceneKeyPages, areMadeFromTheTable) {
    expectPage("docs/scene-keys.md", markdown());
    expectPage("tests/fuzz/SceneFuzz.dict", dictionary());
}

} // namespace
} // namespace limpid::io
