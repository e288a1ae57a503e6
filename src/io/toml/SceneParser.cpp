#include "io/toml/SceneParser.h"

#include <cmath>
#include <set>

#include <fmt/format.h>

#include "core/Error.h"
#include "io/Files.h"
#include "io/gltf/Gltf.h"
#include "io/images/HeightImages.h"
#include "io/toml/KeyReader.h"
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
constexpr std::size_t maxNameLength = 100; ///< as the table of keys says

using Names = std::set<std::string>;

/// The entry's own name, or `prefix` and its number; unique among `taken`.
std::string parseName(TomlTable& table, const KeyRow& key, const char* prefix, std::size_t number,
                      Names& taken) {
    std::string name = fmt::format("{}{}", prefix, number);
    readKey(table, key, name);
    if (!isName(name)) table.fail(key.name, std::string(key.text().expected));
    if (!taken.insert(name).second)
        throw InputError(fmt::format("{}expected a name that no other {} has, found \"{}\"",
                                     table.where(key.name), prefix, name));
    return name;
}

Camera parseCamera(TomlTable table) {
    Camera camera;
    readKeys(table, cameraKeys, camera);
    table.finish();
    if (camera.position && camera.target && *camera.position == *camera.target)
        table.fail("target", "a point other than the position");
    return camera;
}

/// The place of the key's text in its names; 0, the default, if the key is absent.
std::size_t parseChoice(TomlTable& table, const KeyRow& key) {
    std::size_t choice = 0;
    table.choice(key.name, choice, key.choice());
    return choice;
}

WaveType parseWaveType(TomlTable& table) {
    return WaveType(parseChoice(table, keyNamed(waveKeys, "type")));
}

/// What of a height map is not plain; loads its images.
void parseHeightMap(TomlTable& table, Wave& wave, const fs::path& folder) {
    const KeyRow &image = keyNamed(waveKeys, "image"), &place = keyNamed(waveKeys, "placement");
    std::string name;
    readKey(table, image, name);
    if (name.empty()) table.fail(image.name, std::string(image.text().expected));
    glm::dvec4 placement(0);
    readKey(table, place, placement);
    if (placement.z <= 0 || placement.w <= 0)
        table.fail(place.name, "[x, z, width, depth] with width and depth > 0");
    wave.center = {placement.x, placement.y};
    wave.size = {placement.z, placement.w};
    double fade = std::min(wave.size.x, wave.size.y) / 16;
    readKey(table, keyNamed(waveKeys, "fade"), fade);
    table.finish(" of a heightmap wave"); // before images are loaded
    try {
        wave.heights = openHeightImages(folder / name, fade / wave.size);
    } catch (const InputError& error) {
        throw InputError(table.where(image.name) + error.what());
    }
}

void parsePhillips(TomlTable& table, Wave& wave) {
    if ((wave.modes & (wave.modes - 1)) != 0) table.fail("modes", "a power of two");
    table.finish(" of a phillips wave");
    if (!raiseSea(wave, windOf(wave)))
        table.fail("wind", fmt::format("a wind that raises waves of {:.3g} to {:.3g} m",
                                       2 * std::min(wave.size.x, wave.size.y) / wave.modes,
                                       std::max(wave.size.x, wave.size.y)));
}

Wave parseWave(TomlTable table, const fs::path& folder) {
    Wave wave = defaultWave(parseWaveType(table));
    readKeys(table, waveKeys, wave);
    if (wave.type == WaveType::HeightMap)
        parseHeightMap(table, wave, folder);
    else if (wave.type == WaveType::Phillips)
        parsePhillips(table, wave);
    table.finish(fmt::format(" of a {} wave", waveTypeNames[std::size_t(wave.type)]));
    return wave;
}

void parseWaves(TomlTable& table, Water& water, const fs::path& folder) {
    const KeyRow& presetKey = keyNamed(waterKeys, "preset");
    const std::size_t preset = parseChoice(table, presetKey);
    double scale = 1;
    readKey(table, keyNamed(waterKeys, "wave_scale"), scale);
    std::vector<TomlTable> waves = table.tables("wave", maxWaves);
    table.finish();
    if (table.has(presetKey.name)) {
        if (!waves.empty()) table.fail(presetKey.name, "no preset beside the waves of [[water.wave]]");
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
    setWaterBody(parseChoice(table, keyNamed(waterKeys, "type")), water);
    readKeys(table, waterKeys, water);
    parseWaves(table, water, folder);
    return water;
}

Light parseLight(TomlTable table, std::size_t number, Names& taken) {
    const std::string name = parseName(table, keyNamed(lightKeys, "name"), "light", number, taken);
    const std::size_t type = parseChoice(table, keyNamed(lightKeys, "type"));
    Light light = defaultLight(type);
    light.name = name;
    if (light.type == LightType::Point && !table.has("position")) table.fail("position", "three numbers");
    readKeys(table, lightKeys, light);
    if (light.isSpot() && light.innerCone >= light.outerCone)
        table.fail("inner_cone", "a number below outer_cone");
    table.finish(fmt::format(" of a {} light", lightTypeNames[type]));
    return light;
}

/// The row of a shape's key, as its own table has it: without the shape's name.
KeyRow shapeKey(std::string_view shape, std::string_view name) {
    KeyRow key = keyNamed(receiverKeys, fmt::format("{}.{}", shape, name));
    key.name = name;
    return key;
}

/// A shape's size, which has no default.
template <typename Size>
void parseSize(TomlTable& shape, const KeyRow& key, std::string_view numbers, Size& size) {
    if (!shape.has(key.name)) shape.fail(key.name, fmt::format("{} > 0", numbers));
    readKey(shape, key, size);
}

Mesh parsePlane(TomlTable table, const glm::vec3& albedo) {
    glm::dvec2 size(1);
    parseSize(table, shapeKey("plane", "size"), "2 numbers", size);
    table.finish();
    return makePlane(size, albedo);
}

Mesh parseBox(TomlTable table, const glm::vec3& albedo) {
    glm::dvec3 size(1);
    parseSize(table, shapeKey("box", "size"), "3 numbers", size);
    table.finish();
    return makeBox(size, albedo);
}

Mesh parseSphere(TomlTable table, const glm::vec3& albedo) {
    double radius = 1;
    int segments = 32;
    parseSize(table, shapeKey("sphere", "radius"), "a number", radius);
    readKey(table, shapeKey("sphere", "segments"), segments);
    table.finish();
    return makeSphere(radius, albedo, segments);
}

std::shared_ptr<const Mesh> loadModel(TomlTable& table, const fs::path& folder, MeshCache& meshes) {
    const KeyRow& key = keyNamed(receiverKeys, "gltf");
    std::string name;
    readKey(table, key, name);
    const fs::path file = folder / name;
    const NamePatterns without = parseWithout(table);
    try {
        requireFile(file);
    } catch (const InputError& error) {
        throw InputError(table.where(key.name) + error.what());
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
    glm::dvec3 color(0.8);
    readKey(table, keyNamed(receiverKeys, "albedo"), color);
    const glm::vec3 albedo(color);
    if (auto plane = table.table("plane"))
        return std::make_shared<const Mesh>(parsePlane(std::move(*plane), albedo));
    if (auto box = table.table("box")) return std::make_shared<const Mesh>(parseBox(std::move(*box), albedo));
    return std::make_shared<const Mesh>(parseSphere(*table.table("sphere"), albedo));
}

Receiver parseReceiver(TomlTable table, std::size_t number, Names& taken, const fs::path& folder,
                       MeshCache& meshes) {
    Receiver receiver;
    receiver.name = parseName(table, keyNamed(receiverKeys, "name"), "receiver", number, taken);
    readKeys(table, receiverKeys, receiver);
    if (receiver.scale.x == 0 || receiver.scale.y == 0 || receiver.scale.z == 0)
        table.fail("scale", "three numbers other than 0");
    const bool shape = !table.has("gltf");
    receiver.mesh = parseMesh(table, folder, meshes);
    table.finish(shape ? " of a receiver" : " of a glTF receiver");
    return receiver;
}

/// A table of plain keys: they go to `object`, which stays as it is without the table.
template <typename S>
void parsePlain(TomlTable& root, std::string_view section, std::span<const Key<S>> keys, S& object) {
    std::optional<TomlTable> table = root.table(section);
    if (!table) return;
    readKeys(*table, keys, object);
    table->finish();
}

CausticsSettings parseCaustics(TomlTable table) {
    CausticsSettings caustics;
    readKeys(table, causticsKeys, caustics);
    if (caustics.splatSize.x > caustics.splatSize.y) table.fail("splat_size", "the smaller size first");
    table.finish();
    return caustics;
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

NamePatterns parseWithout(TomlTable& receiver) {
    const KeyRow& key = keyNamed(receiverKeys, "without");
    const std::string expected(key.text().expected);
    std::vector<std::string> patterns;
    receiver.texts(key.name, patterns, expected);
    for (const std::string& pattern : patterns)
        if (pattern.empty()) receiver.fail(key.name, expected);
    return NamePatterns(std::move(patterns));
}

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
    parsePlain(table, "sky", skyKeys, scene);
    parsePlain(table, "ambient", ambientKeys, scene);
    if (auto caustics = table.table("caustics")) scene.caustics = parseCaustics(std::move(*caustics));
    if (table.has("godrays")) scene.godrays.method = GodrayMethod::None; // unless it says more
    parsePlain(table, "godrays", godrayKeys, scene.godrays);
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
