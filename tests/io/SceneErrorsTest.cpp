#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/SmallGltf.h"
#include "io/TempFolder.h"
#include "io/toml/SceneFile.h"

namespace limpid::io {
namespace {

using test::errorOf;
using test::TempFolder;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr std::string_view receiver = "[[receiver]]\nplane = { size = [2, 2] }\n";

struct TextCase {
    std::string text;  ///< after the two lines of `receiver`
    std::string error; ///< after "scene.toml:"
};

std::ostream& operator<<(std::ostream& out, const TextCase& c) {
    return out << c.text;
}

class SceneErrorsTest : public testing::TestWithParam<TextCase> {};

TEST_P(SceneErrorsTest, NamesPlaceExpectedAndFound) {
    const TempFolder folder;
    const auto file = folder.write("scene.toml", std::string(receiver) + GetParam().text);
    EXPECT_EQ(errorOf(folder, [&] { loadScene(file); }), "scene.toml:" + GetParam().error);
}

const TextCase waterAndCamera[] = {
    {"[water]\n  grid = \"abc\"",
     "4:10: water.grid: expected two whole numbers from 1 to 8192, found \"abc\""},
    {"[water]\ngrid = [0, 1]", "4:8: water.grid: expected two whole numbers from 1 to 8192, found [0, 1]"},
    {"[water]\ngrid = [1.5, 1]",
     "4:8: water.grid: expected two whole numbers from 1 to 8192, found [1.5, 1]"},
    {"[water]\nior = 0.9", "4:7: water.ior: expected a number from 1 to 4, found 0.9"},
    {"[water]\nior = nan", "4:7: water.ior: expected a number from 1 to 4, found nan"},
    {"[water]\nlevel = inf", "4:9: water.level: expected a number from -1e12 to 1e12, found inf"},
    {"[water]\nlevel = true", "4:9: water.level: expected a number from -1e12 to 1e12, found true"},
    {"[water]\nlevel = 1e300", "4:9: water.level: expected a number from -1e12 to 1e12, found 1e+300"},
    {"[water]\nsize = [1]", "4:8: water.size: expected two numbers > 0 and <= 1e12, found [1]"},
    {"[water]\nabsorption = [1, -1, 1]",
     "4:14: water.absorption: expected three numbers from 0 to 1e12, found [1, -1, 1]"},
    {"[water]\nanisotropy = 1", "4:14: water.anisotropy: expected a number > -1 and < 1, found 1"},
    {"[water]\nlevle = 1", "4:1: water.levle: unknown key, did you mean \"level\"?"},
    {"water = 1",
     "3:1: receiver.0.water: unknown key of a receiver, expected one of albedo, box, gltf, name, plane, "
     "rotation, scale, sphere, translation"},
    {"[watr]", "3:2: watr: unknown key, did you mean \"water\"?"},
    {"[camera]\nvertical_fov = 180", "4:16: camera.vertical_fov: expected a number > 0 and < 180, found 180"},
    {"[camera]\nup = [0, 0, 0]", "4:6: camera.up: expected a vector of a length > 0, found [0, 0, 0]"},
    {"[camera]\nposition = [1, 1, 1]\ntarget = [1, 1, 1]",
     "5:10: camera.target: expected a point other than the position, found [1, 1, 1]"},
};

const TextCase waves[] = {
    {"[[water.wave]]\ntype = \"sine\"", "4:8: water.wave.0.type: expected \"cosine\", \"circular\", "
                                        "\"noise\", \"heightmap\" or \"phillips\", found \"sine\""},
    {"[[water.wave]]\ntype = \"phillips\"\nmodes = 48",
     "5:9: water.wave.0.modes: expected a power of two, found 48"},
    {"[[water.wave]]\ntype = \"phillips\"\nwind = [0.01, 0]",
     "5:8: water.wave.0.wind: expected a wind that raises waves of 0.125 to 4 m, found [0.01, 0]"},
    {"[[water.wave]]\ntype = \"phillips\"\nspeed = 1",
     "5:1: water.wave.0.speed: unknown key of a phillips wave, did you mean \"seed\"?"},
    {"[[water.wave]]\nwavelength = 0",
     "4:14: water.wave.0.wavelength: expected a number > 0 and <= 1e12, found 0"},
    {"[[water.wave]]\ndirection = [0, 0]",
     "4:13: water.wave.0.direction: expected a vector of a length > 0, found [0, 0]"},
    {"[[water.wave]]\ntype = \"noise\"\noctaves = 13",
     "5:11: water.wave.0.octaves: expected a whole number from 1 to 12, found 13"},
    {"[[water.wave]]\ntype = \"noise\"\nseed = -1",
     "5:8: water.wave.0.seed: expected a whole number from 0 to 4294967295, found -1"},
    {"[[water.wave]]\ntype = \"noise\"\ndirection = [1, 0]",
     "5:1: water.wave.0.direction: unknown key of a noise wave, expected one of amplitude, octaves, seed, "
     "speed, "
     "type, wavelength"},
    {"[water]\npreset = \"storm\"", "4:10: water.preset: expected \"calm pool\", \"breeze\", \"rain drops\", "
                                    "\"circular + noise\" or \"cosine + strong noise\", found \"storm\""},
    {"[water]\npreset = \"breeze\"\n[[water.wave]]",
     "4:10: water.preset: expected no preset beside the waves of [[water.wave]], found \"breeze\""},
    {"[water]\nwave = 3", "4:8: water.wave: expected an array of tables, [[water.wave]], found 3"},
};

const TextCase lights[] = {
    {"[[light]]\ntype = \"sun\"",
     "4:8: light.0.type: expected \"directional\", \"point\" or \"spot\", found \"sun\""},
    {"[[light]]\ndirection = [0, 0, 0]",
     "4:13: light.0.direction: expected a vector of a length > 0, found [0, 0, 0]"},
    {"[[light]]\nangular_diameter = 11",
     "4:20: light.0.angular_diameter: expected a number from 0 to 10, found 11"},
    {"[[light]]\nname = \"a\"\nirradiance = [-1, 0, 0]",
     "5:14: light.a.irradiance: expected three numbers from 0 to 1e12, found [-1, 0, 0]"},
    {"[[light]]\ntype = \"point\"", "3:1: light.0.position: expected three numbers, found nothing"},
    {"[[light]]\ntype = \"point\"\nposition = [0, 0, 0]\ndirection = [0, -1, 0]",
     "6:1: light.0.direction: unknown key of a point light, expected one of intensity, name, position, type"},
    {"[[light]]\ntype = \"spot\"\nposition = [0, 0, 0]\nouter_cone = 91",
     "6:14: light.0.outer_cone: expected a number > 0 and <= 90, found 91"},
    {"[[light]]\ntype = \"spot\"\nposition = [0, 0, 0]\ninner_cone = 45",
     "6:14: light.0.inner_cone: expected a number below outer_cone, found 45"},
    {"[[light]]\nposition = [0, 0, 0]", "4:1: light.0.position: unknown key of a directional light, expected "
                                        "one of angular_diameter, direction, "
                                        "irradiance, name, type"},
    {"[[light]]\nname = \"a/b\"", "4:8: light.a/b.name: expected a name of 1 to 100 letters, digits, _, - "
                                  "and ., no dot in front, found \"a/b\""},
    {"[[light]]\nname = 5",
     "4:8: light.0.name: expected a name of 1 to 100 letters, digits, _, - and ., no dot in front, found 5"},
    {"[[light]]\nname = \"a\"\n[[light]]\nname = \"a\"",
     "6:8: light.a.name: expected a name that no other light has, found \"a\""},
    {"[[light]]\nname = \"light1\"\n[[light]]",
     "5:1: light.1.name: expected a name that no other light has, found \"light1\""},
};

const TextCase receivers[] = {
    {"name = \"..\"", "3:8: receiver....name: expected a name of 1 to 100 letters, digits, _, - and ., no "
                      "dot in front, found \"..\""},
    {"rotation = [0, 0, 0, 0]",
     "3:12: receiver.0.rotation: expected a vector of a length > 0, found [0, 0, 0, 0]"},
    {"scale = [1, 0, 1]", "3:9: receiver.0.scale: expected three numbers other than 0, found [1, 0, 1]"},
    {"albedo = [1, 1, -0.1]",
     "3:10: receiver.0.albedo: expected three numbers from 0 to 1e12, found [1, 1, -0.1]"},
    {"box = { size = [1, 1, 1] }",
     "1:1: receiver.0: expected exactly one of plane, sphere, box and gltf, found 2"},
    {"[[receiver]]", "3:1: receiver.1: expected exactly one of plane, sphere, box and gltf, found none"},
    {"[[receiver]]\nsphere = { radius = 0 }",
     "4:21: receiver.1.sphere.radius: expected a number > 0 and <= 1e12, found 0"},
    {"[[receiver]]\nsphere = { radius = 1, segments = 2 }",
     "4:35: receiver.1.sphere.segments: expected a whole number from 4 to 1024, found 2"},
    {"[[receiver]]\nsphere = {}", "4:10: receiver.1.sphere.radius: expected a number > 0, found nothing"},
    {"[[receiver]]\nsphere = 1", "4:10: receiver.1.sphere: expected a table, found 1"},
    {"[[receiver]]\nbox = { size = [1, 1] }",
     "4:16: receiver.1.box.size: expected three numbers > 0 and <= 1e12, found [1, 1]"},
    {"[[receiver]]\nplane = { size = [1, 1], color = 1 }",
     "4:26: receiver.1.plane.color: unknown key, expected one of size"},
    {"[[receiver]]\ngltf = 1", "4:8: receiver.1.gltf: expected the path of a .glb or .gltf file, found 1"},
    {"[[receiver]]\ngltf = \"none.glb\"",
     "4:8: receiver.1.gltf: none.glb: expected a file, found nothing of that name"},
};

const TextCase settings[] = {
    {"[caustics]\nmethod = \"photons\"",
     "4:10: caustics.method: expected \"exact-beam\", \"level-map\", \"level-map-smart\", "
     "\"volumetric\", \"stencil\" or \"photon-splat\" (the methods there are so far), found \"photons\""},
    {"[caustics]\nsplat_size = [20, 5]",
     "4:14: caustics.splat_size: expected the smaller size first, found [20, 5]"},
    {"[caustics]\nfill = \"painted\"",
     "4:8: caustics.fill: expected \"one-pass\" or \"drawn\", found \"painted\""},
    {"[caustics]\nmap_size = 16385",
     "4:12: caustics.map_size: expected a whole number from 1 to 16384, found 16385"},
    {"[caustics]\nplanes = 0", "4:10: caustics.planes: expected a whole number from 1 to 4096, found 0"},
    {"[caustics]\nthreshold = 0", "4:13: caustics.threshold: expected a number > 0 and <= 1, found 0"},
    {"[godrays]\nmethod = \"shafts\"", "4:10: godrays.method: expected \"none\", \"photon-lines\", "
                                       "\"exact-shafts\" or \"tetrahedra\", found \"shafts\""},
    {"[godrays]\nplanes = 0", "4:10: godrays.planes: expected a whole number from 1 to 1024, found 0"},
    {"[godrays]\nsteps = 5000", "4:9: godrays.steps: expected a whole number from 1 to 4096, found 5000"},
    {"[godrays]\nsub_volumes = 257",
     "4:15: godrays.sub_volumes: expected a whole number from 0 to 256, found 257"},
    {"[sky]\nradiance = 1", "4:12: sky.radiance: expected three numbers from 0 to 1e12, found 1"},
};

INSTANTIATE_TEST_SUITE_P(WaterAndCamera, SceneErrorsTest, testing::ValuesIn(waterAndCamera));
INSTANTIATE_TEST_SUITE_P(Waves, SceneErrorsTest, testing::ValuesIn(waves));
INSTANTIATE_TEST_SUITE_P(Lights, SceneErrorsTest, testing::ValuesIn(lights));
INSTANTIATE_TEST_SUITE_P(Receivers, SceneErrorsTest, testing::ValuesIn(receivers));
INSTANTIATE_TEST_SUITE_P(Settings, SceneErrorsTest, testing::ValuesIn(settings));

struct OverrideCase {
    Override override;
    std::string error;
};

std::ostream& operator<<(std::ostream& out, const OverrideCase& c) {
    return out << c.override.key << '=' << c.override.value;
}

class OverrideErrorsTest : public testing::TestWithParam<OverrideCase> {};

TEST_P(OverrideErrorsTest, NamesTheOverride) {
    const TempFolder folder;
    const auto file =
        folder.write("scene.toml", std::string(receiver) + "[[light]]\nname = \"sun\"\n[[light]]\n");
    EXPECT_EQ(errorOf(folder, [&] { loadScene(file, {GetParam().override}); }), GetParam().error);
}

const OverrideCase overrides[] = {
    {{"light.sun.directon", "[0, 0, 1]"},
     "--set light.sun.directon=[0, 0, 1]: unknown key of a directional light, did you mean \"direction\"?"},
    {{"watr.level", "1"}, "--set watr.level=1: unknown key, did you mean \"water\"?"},
    {{"water.level", "high"}, "--set water.level=high: expected a number from -1e12 to 1e12, found \"high\""},
    {{"water.grid", "[1, \"a\\"},
     "--set water.grid=[1, \"a\\: expected two whole numbers from 1 to 8192, found \"[1, \"a\\\""},
    {{"water.level", "1\nior = 2"},
     "--set water.level=1 ior = 2: expected a number from -1e12 to 1e12, found \"1 ior = 2\""},
    {{"water", "{ level = true }"},
     "--set water={ level = true }: water.level: expected a number from -1e12 to 1e12, found true"},
    {{"light.moon.direction", "1"},
     "--set light.moon.direction=1: expected the name or number of a light (there are sun, light1), found "
     "\"moon\""},
    {{"light.2.direction", "1"},
     "--set light.2.direction=1: expected the name or number of a light (there are sun, light1), found "
     "\"2\""},
    {{"water.wave.0.amplitude", "1"},
     "--set water.wave.0.amplitude=1: expected the name or number of a wave (there are none), found \"0\""},
    {{"receiver.0.plane.size.x", "1"},
     "--set receiver.0.plane.size.x=1: unknown key, receiver.plane.size is no table"},
    {{"", "1"}, "--set =1: expected the dotted key of a value, found \"\""},
    {{"water.wave", "1"}, "--set water.wave=1: expected an array of tables, [[water.wave]], found 1"},
    {{"light.0", "1"}, "--set light.0=1: expected the dotted key of a value, found \"light.0\""},
    {{"water.", "1"}, "--set water.=1: expected the dotted key of a value, found \"water.\""},
};

INSTANTIATE_TEST_SUITE_P(All, OverrideErrorsTest, testing::ValuesIn(overrides));

TEST(SceneFileErrorsTest, FilesThatAreNoScenes) {
    const TempFolder folder;
    const auto load = [&](const char* name) {
        return errorOf(folder, [&] { loadScene(folder.path() / name); });
    };
    std::filesystem::create_directory(folder.path() / "folder.toml");
    folder.write("empty.toml", "");
    folder.write("scene.obj", "v");
    folder.write("scene", "v");
    folder.write("nothing.toml", "# nothing\n");
    folder.write("syntax.toml", "[water]\nlevel = = 1\n");
    folder.write("bytes.toml", "\xff\xfe");
    EXPECT_EQ(load("none.toml"), "none.toml: expected a file, found nothing of that name");
    EXPECT_EQ(load("folder.toml"), "folder.toml: expected a file, found a folder");
    EXPECT_EQ(load("empty.toml"), "empty.toml: expected a file, found an empty file");
    EXPECT_EQ(load("scene.obj"), "scene.obj: expected a .toml, .glb or .gltf file, found \".obj\"");
    EXPECT_EQ(load("scene"), "scene: expected a .toml, .glb or .gltf file, found \"\"");
    EXPECT_EQ(load("nothing.toml"), "nothing.toml: receiver: expected at least one [[receiver]], found none");
    EXPECT_THAT(load("syntax.toml"), StartsWith("syntax.toml:2:9: expected valid TOML, found an error: "));
    EXPECT_THAT(load("syntax.toml"), Not(HasSubstr("\n")));
    EXPECT_THAT(load("bytes.toml"), StartsWith("bytes.toml:1:1: expected valid TOML, found an error: "));
}

// toml++ goes down into them by recursion: files like these ended the program, with nothing said.
TEST(SceneFileErrorsTest, KeysOfManyParts) {
    const TempFolder folder;
    std::string parts = "a";
    for (int i = 0; i < 100'000; ++i)
        parts += ".a";
    for (const std::string& text : {parts + " = 1\n", "[" + parts + "]\n", "[[" + parts + "]]\n",
                                    "[water]\nx = { " + parts + " = 1 }\n", "a = ''\n" + parts + " = 1\n",
                                    "a = \"\"\"\"\"\"\"\n" + parts + " = 1\n", "'#'." + parts + " = 1\n"})
        EXPECT_THAT(errorOf(folder, [&] { loadScene(folder.write("deep.toml", text)); }),
                    HasSubstr(": expected keys of at most 64 parts, found a longer one"));
    const auto file = folder.write("scene.toml", receiver);
    EXPECT_THAT(errorOf(folder,
                        [&] {
                            loadScene(file, {{parts, "1"}});
                        }),
                HasSubstr("expected a key of fewer parts"));
    EXPECT_EQ(errorOf(folder,
                      [&] {
                          loadScene(file, {{"receiver.0.name", parts.substr(0, 99)}});
                      }),
              "no error");
    // Dots that separate nothing.
    const std::string dots(500, '.');
    const std::string harmless =
        "# " + dots + "\n[[receiver]] # " + dots + "\nplane = { size = [1.5, 1.5] }\n";
    EXPECT_EQ(errorOf(folder, [&] { loadScene(folder.write("dots.toml", harmless)); }), "no error");
    for (const char* quotes : {"\"", "'", "\"\"\"", "'''"}) {
        const std::string text = harmless + "[sky]\nx = " + quotes + "\\\\" + dots + quotes + "\n";
        EXPECT_THAT(errorOf(folder, [&] { loadScene(folder.write("dots.toml", text)); }),
                    HasSubstr("sky.x: unknown key"));
    }
}

TEST(SceneFileErrorsTest, TooManyEntries) {
    const TempFolder folder;
    std::string text(receiver);
    for (int i = 0; i < 65; ++i)
        text += "[[light]]\n";
    const auto file = folder.write("scene.toml", text);
    EXPECT_EQ(errorOf(folder, [&] { loadScene(file); }),
              "scene.toml:3:1: light: expected at most 64 entries, found 65");
}

TEST(SceneFileErrorsTest, ModelsBringTheirOwnAlbedo) {
    const TempFolder folder;
    folder.write("fish.gltf", test::triangleGltf().text());
    const auto file = folder.write("scene.toml", "[[receiver]]\ngltf = \"fish.gltf\"\nalbedo = [1, 1, 1]\n");
    EXPECT_THAT(
        errorOf(folder, [&] { loadScene(file); }),
        StartsWith("scene.toml:3:1: receiver.0.albedo: unknown key of a glTF receiver, expected one of "));
}

TEST(SceneFileErrorsTest, NamesThatWouldShareAFile) {
    const TempFolder folder;
    const auto file = folder.write("scene.toml", R"(
receiver = [{ name = "a", plane = { size = [1, 1] } }, { name = "a.b", plane = { size = [1, 1] } }]
light = [{ name = "b.c" }, { name = "c" }])");
    EXPECT_EQ(
        errorOf(folder, [&] { loadScene(file); }),
        "scene.toml: expected names that tell receivers and lights apart, found two pairs named \"a.b.c\"");
}

} // namespace
} // namespace limpid::io
