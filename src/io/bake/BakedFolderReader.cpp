#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/Error.h"
#include "io/Files.h"
#include "io/bake/BakedFolder.h"
#include "io/images/Images.h"

namespace fs = std::filesystem;

namespace limpid::io {

namespace {

using Json = nlohmann::json;

std::string found(const Json& json) {
    return oneLine(json.dump(-1, ' ', true, Json::error_handler_t::replace), 60);
}

/// A value of the index and its place, for errors.
class Entry {
  public:
    Entry(const Json& json, std::string place) : _json(json), _place(std::move(place)) {}

    [[noreturn]] void fail(const std::string& expected) const {
        throw InputError(fmt::format("{}: expected {}, found {}", _place, expected, found(_json)));
    }

    bool has(const char* key) const { return object().contains(key); }
    Entry operator[](const char* key) const {
        if (!has(key)) throw InputError(fmt::format("{}: expected \"{}\", found none", _place, key));
        return {_json[key], fmt::format("{}.{}", _place, key)};
    }

    std::string text() const {
        if (!_json.is_string()) fail("a text");
        return _json.get<std::string>();
    }
    double number() const {
        if (!_json.is_number() || !std::isfinite(_json.get<double>())) fail("a number");
        return _json.get<double>();
    }
    int wholeNumber(int min, int max) const {
        if (!_json.is_number_integer() || _json.get<double>() < min || _json.get<double>() > max)
            fail(fmt::format("a whole number from {} to {}", min, max));
        return _json.get<int>();
    }
    std::vector<Entry> list() const {
        if (!_json.is_array()) fail("a list");
        std::vector<Entry> entries;
        for (std::size_t i = 0; i < _json.size(); ++i)
            entries.emplace_back(_json[i], fmt::format("{}[{}]", _place, i));
        return entries;
    }
    std::vector<Entry> list(std::size_t length) const {
        std::vector<Entry> entries = list();
        if (entries.size() != length) fail(fmt::format("a list of {}", length));
        return entries;
    }

    // What is not there is left as it is.
    void read(const char* key, std::string& value) const {
        if (has(key)) value = (*this)[key].text();
    }
    void read(const char* key, double& value) const {
        if (has(key)) value = (*this)[key].number();
    }
    void read(const char* key, int& value) const {
        if (has(key)) value = (*this)[key].wholeNumber(0, std::numeric_limits<int>::max());
    }
    void read(const char* key, std::int64_t& value) const {
        if (!has(key)) return;
        const Entry entry = (*this)[key];
        if (!entry._json.is_number_unsigned() || entry._json.get<std::uint64_t>() >> 62 != 0)
            entry.fail("a whole number from 0 to 4e18");
        value = entry._json.get<std::int64_t>();
    }

  private:
    const Json& object() const {
        if (!_json.is_object()) fail("an object");
        return _json;
    }

    const Json& _json;
    std::string _place;
};

/// The place of byte `position` (1 is the first): line and column.
std::string lineAndColumn(const std::vector<std::uint8_t>& bytes, std::size_t position) {
    const auto end = bytes.begin() + std::ptrdiff_t(std::min(position > 0 ? position - 1 : 0, bytes.size()));
    const auto line = std::find(std::make_reverse_iterator(end), bytes.rend(), std::uint8_t('\n')).base();
    return fmt::format("{}:{}", 1 + std::count(bytes.begin(), end, std::uint8_t('\n')), 1 + (end - line));
}

Json parseIndex(const fs::path& file) {
    const std::vector<std::uint8_t> bytes = readBytes(file);
    try {
        return Json::parse(bytes);
    } catch (const Json::parse_error& error) {
        throw InputError(fmt::format("{}:{}: expected JSON, found something else", oneLine(file.string()),
                                     lineAndColumn(bytes, error.byte)));
    }
}

std::vector<float> readMap(const fs::path& folder, const Entry& entry, glm::ivec2 size,
                           const std::vector<std::string>& channels) {
    const fs::path file = folder / entry.text();
    FloatImage image = readImage(file);
    if (image.width != size.x || image.height != size.y)
        throw InputError(fmt::format("{}: expected {} x {} pixels as in index.json, found {} x {}",
                                     oneLine(file.string()), size.x, size.y, image.width, image.height));
    if (image.channelNames != channels)
        throw InputError(fmt::format("{}: expected channels {}, found {}", oneLine(file.string()),
                                     fmt::join(channels, ", "),
                                     oneLine(fmt::to_string(fmt::join(image.channelNames, ", ")))));
    return std::move(image.data);
}

glm::dmat4 readMatrix(const Entry& entry) {
    glm::dmat4 matrix(1);
    const std::vector<Entry> numbers = entry.list(16);
    for (int i = 0; i < 16; ++i)
        matrix[i / 4][i % 4] = numbers[std::size_t(i)].number();
    if (!(std::abs(glm::determinant(matrix)) > 0)) entry.fail("an invertible matrix");
    return matrix;
}

BakedMap readMapEntry(const fs::path& folder, const Entry& entry) {
    BakedMap map;
    map.receiver = entry["receiver"].text();
    map.light = entry["light"].text();
    const std::vector<Entry> size = entry["size"].list(2);
    map.size = {size[0].wholeNumber(1, 1 << 16), size[1].wholeNumber(1, 1 << 16)};
    map.worldToTexture = readMatrix(entry["world_to_texture"]);
    entry.read("facing", map.facing);
    if (entry.has("standard_error")) map.standardError = entry["standard_error"].number();
    if (entry.has("planes")) {
        entry["planes"].read("requested", map.planesRequested);
        entry["planes"].read("drawn", map.planesDrawn);
    }
    if (entry.has("flux")) entry["flux"].read("deposited", map.deposited);
    map.irradiance = readMap(folder, entry["irradiance"], map.size, {"R", "G", "B"});
    map.position = readMap(folder, entry["position"], map.size, {"R", "G", "B", "A"});
    map.normal = readMap(folder, entry["normal"], map.size, {"R", "G", "B"});
    return map;
}

BakedFlux readFlux(const Entry& entry) {
    BakedFlux flux;
    entry.read("entering", flux.entering);
    entry.read("absorbed", flux.absorbed);
    entry.read("scattered", flux.scattered);
    entry.read("deposited", flux.deposited);
    entry.read("missed", flux.missed);
    entry.read("rejected", flux.rejected);
    entry.read("residual", flux.residual);
    if (entry.has("standard_error")) flux.standardError = entry["standard_error"].number();
    return flux;
}

BakedLight readLight(const Entry& entry) {
    BakedLight light;
    light.light = entry["light"].text();
    entry.read("beams", light.beams);
    entry.read("beams_drawn", light.beamsDrawn);
    if (entry.has("flux")) light.flux = readFlux(entry["flux"]);
    return light;
}

} // namespace

Bake readBake(const fs::path& folder) {
    const fs::path file = folder / "index.json";
    const Json json = parseIndex(file);
    const Entry index(json, oneLine(file.string()));
    Bake bake;
    index.read("device", bake.device);
    index.read("input", bake.input);
    index.read("method", bake.method);
    index.read("time", bake.time);
    if (index.has("origin")) {
        const std::vector<Entry> origin = index["origin"].list(3);
        for (int c = 0; c < 3; ++c)
            bake.origin[c] = origin[std::size_t(c)].number();
    }
    if (index.has("lights"))
        for (const Entry& light : index["lights"].list())
            bake.lights.push_back(readLight(light));
    for (const Entry& map : index["maps"].list())
        bake.maps.push_back(readMapEntry(folder, map));
    return bake;
}

} // namespace limpid::io
