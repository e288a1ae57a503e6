// Every key of the table, changed on a live engine: what it then shows is, bit for bit, what an engine shows that makes
// all anew and leaves no work out. That is what guards against a product that is kept though its key has changed.
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "core/Error.h"
#include "engine/EngineFixture.h"
#include "io/TempFolder.h"
#include "io/images/Images.h"
#include "io/toml/SceneFile.h"
#include "scene/Keys.h"

namespace limpid {
namespace {

/// One entry of each kind, so that every key counts somewhere.
constexpr const char* text = R"(
[camera]
position = [0.3, -0.4, 1.5]
target = [0, -0.5, 0]
[water]
grid = [6, 6]
scattering = [0.1, 0.1, 0.1]
[[water.wave]]
type = "cosine"
speed = 0.1
[[water.wave]]
type = "circular"
[[water.wave]]
type = "noise"
[[water.wave]]
type = "phillips"
amplitude = 0.002
modes = 4
[[water.wave]]
type = "heightmap"
image = "heights.exr"
placement = [0, 0, 2, 2]
amplitude = 0.01
[[light]]
name = "sun"
direction = [0.2, -1, 0.1]
[[light]]
type = "spot"
position = [0.4, 1, 0]
direction = [0, -1, 0]
inner_cone = 10
[[receiver]]
plane = { size = [1, 1] }
translation = [0, -0.9, 0]
[[receiver]]
sphere = { radius = 0.15, segments = 8 }
translation = [0.1, -0.5, 0]
[[receiver]]
box = { size = [0.2, 0.3, 0.2] }
translation = [-0.3, -0.3, 0]
[caustics]
map_size = 10
planes = 3
photon_grid = [12, 12]
[godrays]
scale = 0.5
planes = 3
steps = 4
grid = [6, 6]
)";
constexpr std::size_t entries = 5;
constexpr glm::ivec2 size{16, 12};
constexpr double time = 0.45;

/// A method, whether the box stands out of the water (its shadow map takes long), and what keys to change.
struct Run {
    const char* method;
    bool dry;
    std::vector<std::string_view> sections;
};

class EveryKeyGLTest : public EngineGLTest, public testing::WithParamInterface<Run> {
  protected:
    EveryKeyGLTest() {
        std::vector<float> heights;
        for (int i = 0; i < 16 * 16; ++i)
            heights.push_back(0.1f * float(i % 5) - 0.2f);
        io::writeExr(folder.path() / "heights.exr", 16, 16, {"Y"}, heights);
        file = folder.write("scene.toml", text);
    }
    Scene load(const std::vector<io::Override>& overrides) const {
        // Keys of godrays alone would leave them off.
        std::vector<io::Override> all = chosen();
        all.insert(all.end(), overrides.begin(), overrides.end());
        return io::loadScene(file, all);
    }
    static std::vector<io::Override> chosen() {
        const std::string method = GetParam().method;
        std::vector<io::Override> all{{"caustics.method", method}};
        if (method == "level-map-smart") all.push_back({"caustics.slicing", "levels"});
        const char* godrays = method == "photon-splat"      ? "photon-lines"
                              : method == "level-map-smart" ? "tetrahedra"
                                                            : "exact-shafts";
        all.push_back({"godrays.method", godrays});
        if (GetParam().dry) all.push_back({"receiver.2.translation", "[-0.3, -0.1, 0]"});
        return all;
    }
    /// What another reading of the file has made anew though it is the same.
    static Scene withPartsOf(Scene scene, const Scene& base, const KeyFacts& key, std::size_t entry) {
        for (std::size_t i = 0; i < scene.receivers.size(); ++i)
            if (key.section != "receiver" || i != entry) scene.receivers[i] = base.receivers[i];
        if (key.section == "receiver" && (key.name == "translation" || key.name == "rotation" || key.name == "scale"))
            scene.receivers[entry].mesh = base.receivers[entry].mesh;
        for (std::size_t i = 0; i < scene.water.waves.size() && i < base.water.waves.size(); ++i)
            if (key.name != "wave_scale" && key.name != "preset" && (key.section != "water.wave" || i != entry))
                scene.water.waves[i] = base.water.waves[i];
        return scene;
    }

    struct Shown {
        std::vector<float> picture;
        std::vector<std::vector<float>> maps;
        bool operator==(const Shown&) const = default;
    };
    static Shown show(Engine& engine, const Scene& scene) {
        engine.set(scene);
        Shown shown{engine.render(time, size).rgb, {}};
        engine.updateCaustics(time);
        for (const MapWork& map : engine.maps())
            shown.maps.push_back(readMaps(map, engine.origin()).irradiance);
        return shown;
    }

    test::TempFolder folder;
    std::filesystem::path file;
    /// One for all methods: each compiles its shaders for itself.
    Engine& live = sharedEngine();
    static Engine& workingEngine() {
        static Engine engine(context());
        engine.setSkipping(false);
        return engine;
    }
    Engine& working = workingEngine();
};

/// Whether a receiver of the text has the shape that a key is of.
bool fits(const KeyFacts& key, std::size_t entry) {
    constexpr std::string_view shapes[] = {"plane", "sphere", "box"};
    for (std::size_t i = 0; i < std::size(shapes); ++i)
        if (key.name.starts_with(shapes[i]) && key.name.find('.') != key.name.npos) return entry == i;
    return key.name != "albedo" || entry < std::size(shapes);
}

TEST_P(EveryKeyGLTest, changedLiveShowsWhatAnEngineShowsThatMakesAllAnew) {
    const Scene base = load({});
    const auto& sections = GetParam().sections;
    const Shown before = show(live, base);
    EXPECT_EQ(before, show(working, base));
    int changed = 0, differs = 0;
    for (const KeyFacts& key : sceneKeys())
        for (std::size_t entry = 0; entry < (key.listed ? entries : 1); ++entry) {
            if (std::find(sections.begin(), sections.end(), key.section) == sections.end()) continue;
            const std::string another = key.another(base, entry);
            if (another.empty() || key.name == "type" || !fits(key, entry)) continue; // of waves: other keys come with it
            SCOPED_TRACE(key.path(entry) + " = " + another);
            const Scene scene = withPartsOf(load({{key.path(entry), another}}), base, key, entry);
            const Shown now = show(live, scene);
            ASSERT_EQ(now, show(working, scene));
            ++changed;
            if (now != before) ++differs;
            ASSERT_EQ(show(live, base), before) << "and back";
        }
    printf("%s: %d changes, %d of them show\n", GetParam().method, changed, differs);
    EXPECT_GT(differs, int(4 * sections.size()));
}

const std::vector<std::string_view> everything = {"camera",   "water", "water.wave", "light",  "receiver",
                                                  "caustics", "sky",   "ambient",    "godrays"};
const std::vector<std::string_view> settings = {"caustics", "godrays"};

INSTANTIATE_TEST_SUITE_P(Methods, EveryKeyGLTest,
                         testing::Values(Run{"exact-beam", false, everything},
                                         Run{"level-map-smart", false, everything},
                                         Run{"exact-beam", true, {"light", "receiver"}},
                                         Run{"photon-splat", false, settings}, Run{"level-map", false, settings},
                                         Run{"stencil", false, settings}, Run{"volumetric", false, settings}),
                         [](const auto& run) {
                             std::string name = run.param.method;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name + (run.param.dry ? "_dry" : "");
                         });

} // namespace
} // namespace limpid
