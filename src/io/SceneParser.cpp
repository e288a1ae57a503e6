#include "io/SceneParser.h"

#include <cmath>
#include <set>

#include <fmt/format.h>

#include "core/Error.h"
#include "io/Files.h"
#include "io/Gltf.h"
#include "io/HeightImages.h"
#include "io/TomlReader.h"
#include "scene/Sea.h"
#include "scene/Shapes.h"
#include "scene/WaterBodies.h"
#include "scene/WaterPresets.h"

namespace fs = std::filesystem;

namespace limpid::io {

namespace {

constexpr std::size_t maxLights = 64;
constexpr std::size_t maxReceivers = 4096;
constexpr std::size_t maxWaves = 1024;
constexpr std::size_t maxNameLength = 100;

using Names = std::set<std::string>;

/// The entry's own name, or `prefix` and its number; unique among `taken`.
std::string parseName(TomlTable& table, const char* prefix, std::size_t number, Names& taken) {
    std::string name = fmt::format("{}{}", prefix, number);
    const std::string expected =
        fmt::format("a name of 1 to {} letters, digits, _, - and ., no dot in front", maxNameLength);
    table.text("name", name, expected);
    if (!isName(name)) table.fail("name", expected);
    if (!taken.insert(name).second)
        throw InputError(fmt::format("{}expected a name that no other {} has, found \"{}\"",
                                     table.where("name"), prefix, name));
    return name;
}

Camera parseCamera(TomlTable table) {
    Camera camera;
    table.vector("position", camera.position, anyNumber);
    table.vector("target", camera.target, anyNumber);
    table.direction("up", camera.up);
    table.number("vertical_fov", camera.verticalFov,
                 {.min = 0, .max = 180, .openMin = true, .openMax = true, .text = " > 0 and < 180"});
    table.number("exposure", camera.exposure, {.min = -64, .max = 64, .text = " from -64 to 64"});
    table.finish();
    if (camera.position && camera.target && *camera.position == *camera.target)
        table.fail("target", "a point other than the position");
    return camera;
}

WaveType parseWaveType(TomlTable& table) {
    return static_cast<WaveType>(table.choice("type", waveTypeNames));
}

void parseHeightMap(TomlTable& table, Wave& wave, const fs::path& folder) {
    std::string name;
    const std::string expected = "the path of an image, or of a sequence with one %04d";
    table.text("image", name, expected);
    if (name.empty()) table.fail("image", expected);
    glm::dvec4 placement(0);
    table.vector("placement", placement, anyNumber);
    if (placement.z <= 0 || placement.w <= 0)
        table.fail("placement", "[x, z, width, depth] with width and depth > 0");
    wave.center = {placement.x, placement.y};
    wave.size = {placement.z, placement.w};
    table.number("fps", wave.fps, positive);
    double fade = std::min(wave.size.x, wave.size.y) / 16;
    table.number("fade", fade, nonNegative);
    table.finish(" of a heightmap wave"); // before images are loaded
    try {
        wave.heights = openHeightImages(folder / name, fade / wave.size);
    } catch (const InputError& error) {
        throw InputError(table.where("image") + error.what());
    }
}

void parsePhillips(TomlTable& table, Wave& wave) {
    Wind wind;
    table.direction("wind", wind.velocity);
    if (const toml::node* size = table.value("size"); size && size->is_number()) {
        table.number("size", wind.tile.x, positive);
        wind.tile.y = wind.tile.x;
    } else {
        table.vector("size", wind.tile, positive);
    }
    table.wholeNumber("modes", wind.modes, Wind::minModes, Wind::maxModes);
    if ((wind.modes & (wind.modes - 1)) != 0) table.fail("modes", "a power of two");
    table.number("shortest", wind.shortest, positive);
    std::int64_t seed = wind.seed;
    table.wholeNumber("seed", seed, 0, 0xFFFFFFFF);
    wind.seed = static_cast<std::uint32_t>(seed);
    table.finish(" of a phillips wave");
    if (!raiseSea(wave, wind))
        table.fail("wind", fmt::format("a wind that raises waves of {:.3g} to {:.3g} m",
                                       2 * std::min(wind.tile.x, wind.tile.y) / wind.modes,
                                       std::max(wind.tile.x, wind.tile.y)));
}

void parseAnalyticWave(TomlTable& table, Wave& wave) {
    table.number("wavelength", wave.wavelength, positive);
    table.number("speed", wave.speed, anyNumber);
    if (wave.type == WaveType::Noise) {
        std::int64_t seed = wave.seed;
        table.wholeNumber("octaves", wave.octaves, 1, 12);
        table.wholeNumber("seed", seed, 0, 0xFFFFFFFF);
        wave.seed = static_cast<std::uint32_t>(seed);
    } else {
        table.number("phase", wave.phase, anyNumber);
    }
    if (wave.type == WaveType::Cosine) table.direction("direction", wave.direction);
    if (wave.type == WaveType::Circular) table.vector("center", wave.center, anyNumber);
    table.finish(wave.type == WaveType::Noise      ? " of a noise wave"
                 : wave.type == WaveType::Circular ? " of a circular wave"
                                                   : " of a cosine wave");
}

Wave parseWave(TomlTable table, const fs::path& folder) {
    Wave wave;
    wave.type = parseWaveType(table);
    table.number("amplitude", wave.amplitude, anyNumber);
    if (wave.type == WaveType::HeightMap)
        parseHeightMap(table, wave, folder);
    else if (wave.type == WaveType::Phillips)
        parsePhillips(table, wave);
    else
        parseAnalyticWave(table, wave);
    return wave;
}

void parseWaves(TomlTable& table, Water& water, const fs::path& folder) {
    const std::size_t preset = table.choice("preset", waterPresets);
    double scale = 1;
    table.number("wave_scale", scale, anyNumber);
    std::vector<TomlTable> waves = table.tables("wave", maxWaves);
    table.finish();
    if (table.has("preset")) {
        if (!waves.empty()) table.fail("preset", "no preset beside the waves of [[water.wave]]");
        water.waves = presetWaves(preset, water.center.value_or(glm::dvec2(0)));
    }
    int heightMaps = 0;
    for (TomlTable& wave : waves)
        if (isTexture(parseWaveType(wave))) ++heightMaps;
    if (heightMaps > maxHeightMaps)
        throw InputError(fmt::format("{}expected at most {} height maps and spectra, found {}",
                                     table.where("wave"), maxHeightMaps, heightMaps));
    for (TomlTable& wave : waves)
        water.waves.push_back(parseWave(std::move(wave), folder));
    for (Wave& wave : water.waves)
        wave.amplitude *= scale;
}

Water parseWater(TomlTable table, const fs::path& folder) {
    Water water;
    table.number("level", water.level, anyNumber);
    table.vector("center", water.center, anyNumber);
    table.vector("size", water.size, positive);
    table.wholeNumbers("grid", water.grid, 8192);
    table.number("ior", water.ior, {.min = 1, .max = 4, .text = " from 1 to 4"});
    setWaterBody(table.choice("type", waterBodies), water);
    table.vector("absorption", water.absorption, nonNegative);
    table.vector("scattering", water.scattering, nonNegative);
    table.number("anisotropy", water.anisotropy,
                 {.min = -1, .max = 1, .openMin = true, .openMax = true, .text = " > -1 and < 1"});
    parseWaves(table, water, folder);
    return water;
}

void parseCone(TomlTable& table, Light& light) {
    table.direction("direction", light.direction);
    light.outerCone = 45;
    table.number("outer_cone", light.outerCone,
                 {.min = 0, .max = 90, .openMin = true, .text = " > 0 and <= 90"});
    table.number("inner_cone", light.innerCone, nonNegative);
    if (light.innerCone >= light.outerCone) table.fail("inner_cone", "a number below outer_cone");
}

Light parseLight(TomlTable table, std::size_t number, Names& taken) {
    constexpr std::string_view types[] = {"directional", "point", "spot"};
    Light light;
    light.name = parseName(table, "light", number, taken);
    const std::string_view type = types[table.choice("type", types)];
    if (type != "directional") {
        light.type = LightType::Point;
        if (!table.has("position")) table.fail("position", "three numbers");
        table.vector("position", light.position, anyNumber);
        table.vector("intensity", light.intensity, nonNegative);
        if (type == "spot") parseCone(table, light);
        table.finish(type == "spot" ? " of a spot light" : " of a point light");
    } else {
        table.direction("direction", light.direction);
        table.vector("irradiance", light.irradiance, nonNegative);
        table.number("angular_diameter", light.angularDiameter,
                     {.min = 0, .max = 10, .text = " from 0 to 10"});
        table.finish(" of a directional light");
    }
    return light;
}

glm::vec3 parseAlbedo(TomlTable& table) {
    glm::dvec3 albedo(0.8);
    table.vector("albedo", albedo, nonNegative);
    return glm::vec3(albedo);
}

/// A shape's table: its size, which has no default.
template <int N>
glm::vec<N, double> parseSize(TomlTable& receiver, std::string_view shape) {
    TomlTable table = *receiver.table(shape);
    glm::vec<N, double> size(1.0);
    if (!table.has("size")) table.fail("size", fmt::format("{} numbers > 0", N));
    table.vector("size", size, positive);
    table.finish();
    return size;
}

Mesh parseSphere(TomlTable& receiver, const glm::vec3& albedo) {
    TomlTable table = *receiver.table("sphere");
    double radius = 1;
    int segments = 32;
    if (!table.has("radius")) table.fail("radius", "a number > 0");
    table.number("radius", radius, positive);
    table.wholeNumber("segments", segments, 4, 1024);
    table.finish();
    return makeSphere(radius, albedo, segments);
}

std::shared_ptr<const Mesh> loadModel(TomlTable& table, const fs::path& folder, MeshCache& meshes) {
    std::string name;
    table.text("gltf", name, "the path of a .glb or .gltf file");
    const fs::path file = folder / name;
    const NamePatterns without = parseWithout(table);
    try {
        requireFile(file);
    } catch (const InputError& error) {
        throw InputError(table.where("gltf") + error.what());
    }
    std::shared_ptr<const Mesh>& mesh = meshes[{fs::weakly_canonical(file), without}];
    if (!mesh) mesh = std::make_shared<const Mesh>(loadGltf(file, without));
    return mesh;
}

std::shared_ptr<const Mesh> parseMesh(TomlTable& table, const fs::path& folder, MeshCache& meshes) {
    int count = 0;
    for (const std::string_view key : {"plane", "sphere", "box", "gltf"})
        count += table.has(key);
    if (count != 1)
        throw InputError(fmt::format("{}expected exactly one of plane, sphere, box and gltf, found {}",
                                     table.where(""), count == 0 ? "none" : std::to_string(count)));
    if (table.has("gltf")) return loadModel(table, folder, meshes);
    const glm::vec3 albedo = parseAlbedo(table);
    if (table.has("plane"))
        return std::make_shared<const Mesh>(makePlane(parseSize<2>(table, "plane"), albedo));
    if (table.has("box")) return std::make_shared<const Mesh>(makeBox(parseSize<3>(table, "box"), albedo));
    return std::make_shared<const Mesh>(parseSphere(table, albedo));
}

Receiver parseReceiver(TomlTable table, std::size_t number, Names& taken, const fs::path& folder,
                       MeshCache& meshes) {
    Receiver receiver;
    receiver.name = parseName(table, "receiver", number, taken);
    table.vector("translation", receiver.translation, anyNumber);
    glm::dvec4 rotation(0, 0, 0, 1);
    table.direction("rotation", rotation);
    receiver.rotation = glm::normalize(glm::dquat(rotation.w, rotation.x, rotation.y, rotation.z));
    table.vector("scale", receiver.scale, anyNumber);
    if (receiver.scale.x == 0 || receiver.scale.y == 0 || receiver.scale.z == 0)
        table.fail("scale", "three numbers other than 0");
    const bool shape = !table.has("gltf");
    receiver.mesh = parseMesh(table, folder, meshes);
    table.finish(shape ? " of a receiver" : " of a glTF receiver");
    return receiver;
}

void parsePhotons(TomlTable& table, CausticsSettings& caustics) {
    table.wholeNumbers("photon_grid", caustics.photonGrid, 8192);
    caustics.photonGridOver =
        static_cast<PhotonGridOver>(table.choice("photon_grid_over", photonGridOverNames));
    table.wholeNumber("photon_subdivision", caustics.photonSubdivision, 1, 16);
    table.vector("splat_size", caustics.splatSize, {.min = 1, .max = 256, .text = " from 1 to 256"});
    if (caustics.splatSize.x > caustics.splatSize.y) table.fail("splat_size", "the smaller size first");
    table.wholeNumber("filter_taps", caustics.filterTaps, 0, 32);
    table.number("filter_radius", caustics.filterRadius, {.min = 0, .max = 64, .text = " from 0 to 64"});
}

CausticsSettings parseCaustics(TomlTable table) {
    CausticsSettings caustics;
    std::vector<std::string_view> methods{methodName(caustics.method)};
    for (const Method method : allMethods())
        if (method != caustics.method) methods.push_back(methodName(method));
    caustics.method =
        *methodFromName(methods[table.choice("method", methods, " (the methods there are so far)")]);
    table.wholeNumber("map_size", caustics.mapSize, 1, 16384);
    table.number("texels_per_pixel", caustics.texelsPerPixel, {.min = 0, .max = 64, .text = " from 0 to 64"});
    table.number("refresh", caustics.refresh, {.min = 0, .max = 1000, .text = " from 0 to 1000"});
    table.wholeNumber("planes", caustics.planes, 1, 4096);
    std::vector<std::string_view> fills{fillName(caustics.fill)};
    for (const Fill fill : allFills())
        if (fill != caustics.fill) fills.push_back(fillName(fill));
    caustics.fill = *fillFromName(fills[table.choice("fill", fills)]);
    constexpr std::string_view slicings[] = {"automatic", "levels"};
    caustics.slicing = static_cast<Slicing>(table.choice("slicing", slicings));
    table.wholeNumber("depth_levels", caustics.depthLevels, 1, 4096);
    table.number("threshold", caustics.threshold,
                 {.min = 0, .max = 1, .openMin = true, .text = " > 0 and <= 1"});
    parsePhotons(table, caustics);
    table.finish();
    return caustics;
}

void parseRadiance(TomlTable& root, std::string_view key, glm::dvec3& radiance) {
    std::optional<TomlTable> table = root.table(key);
    if (!table) return;
    table->vector("radiance", radiance, nonNegative);
    table->finish();
}

GodraySettings parseGodrays(TomlTable table) {
    GodraySettings godrays;
    std::vector<std::string_view> methods;
    for (const GodrayMethod method : allGodrayMethods())
        methods.push_back(godrayMethodName(method));
    godrays.method = allGodrayMethods()[table.choice("method", methods)];
    constexpr std::string_view phases[] = {"henyey-greenstein", "schlick"};
    godrays.phase = static_cast<Phase>(table.choice("phase", phases));
    table.wholeNumbers("grid", godrays.grid, 4096);
    table.wholeNumber("subdivision", godrays.subdivision, 1, 16);
    table.wholeNumber("planes", godrays.planes, 1, 1024);
    table.wholeNumber("steps", godrays.steps, 1, 4096);
    table.wholeNumber("sub_volumes", godrays.subVolumes, 0, 256);
    table.number("scale", godrays.scale, {.min = 0, .max = 1, .openMin = true, .text = " > 0 and <= 1"});
    table.number("line_width", godrays.lineWidth, {.min = 0.5, .max = 256, .text = " from 0.5 to 256"});
    table.wholeNumber("filter_taps", godrays.filterTaps, 0, 32);
    table.number("filter_radius", godrays.filterRadius, {.min = 0, .max = 64, .text = " from 0 to 64"});
    table.finish();
    return godrays;
}

/// Names become `RECEIVER.LIGHT.…` in file names, where dots inside of them could make two pairs one.
void checkPairs(const Scene& scene, const std::string& file) {
    Names pairs;
    for (const Receiver& receiver : scene.receivers)
        for (const Light& light : scene.lights)
            if (const std::string pair = receiver.name + '.' + light.name; !pairs.insert(pair).second)
                throw InputError(
                    fmt::format("{}: expected names that tell receivers and lights apart, found two "
                                "pairs named \"{}\"",
                                oneLine(file), pair));
}

} // namespace

bool isName(const std::string& name) {
    constexpr std::string_view allowed = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-.";
    return !name.empty() && name.size() <= maxNameLength && name.front() != '.' &&
           name.find_first_not_of(allowed) == std::string::npos;
}

Scene parseScene(const toml::table& root, const fs::path& file, MeshCache& meshes) {
    const std::string fileName = file.string();
    const fs::path folder = file.parent_path();
    TomlTable table(root, "", fileName);
    Scene scene;
    if (auto camera = table.table("camera")) scene.camera = parseCamera(std::move(*camera));
    std::optional<TomlTable> water = table.table("water");
    Names lightNames, receiverNames;
    for (TomlTable& light : table.tables("light", maxLights))
        scene.lights.push_back(parseLight(std::move(light), scene.lights.size(), lightNames));
    parseRadiance(table, "sky", scene.skyRadiance);
    parseRadiance(table, "ambient", scene.ambientRadiance);
    if (auto caustics = table.table("caustics")) scene.caustics = parseCaustics(std::move(*caustics));
    if (auto godrays = table.table("godrays")) scene.godrays = parseGodrays(std::move(*godrays));
    std::vector<TomlTable> receivers = table.tables("receiver", maxReceivers);
    table.finish(); // before files are loaded: a misspelt key should not have to wait for them
    if (water) scene.water = parseWater(std::move(*water), folder);
    if (receivers.empty())
        throw InputError(
            fmt::format("{}: receiver: expected at least one [[receiver]], found none", oneLine(fileName)));
    for (TomlTable& receiver : receivers)
        scene.receivers.push_back(
            parseReceiver(std::move(receiver), scene.receivers.size(), receiverNames, folder, meshes));
    checkPairs(scene, fileName);
    return scene;
}

} // namespace limpid::io
