#include "io/toml/ProfileFile.h"

#include <algorithm>
#include <charconv>
#include <sstream>

#include <fmt/format.h>

#include "core/Error.h"
#include "io/Files.h"
#include "io/toml/SceneParser.h"
#include "io/toml/TomlReader.h"

namespace fs = std::filesystem;

namespace limpid::io {

namespace {

constexpr std::size_t maxValues = 10000; ///< of one list

/// As in a scene file.
template <typename S, typename T>
int mostOf(std::span<const Key<S>> keys, T S::*member) {
    return int(keyOf(keys, member).range().max);
}

/// The values of a list, or the one that stands in its place.
std::vector<const toml::node*> valuesOf(TomlTable& table, std::string_view key) {
    std::vector<const toml::node*> values;
    const toml::node* node = table.value(key);
    if (!node) return values;
    const toml::array* array = node->as_array();
    if (!array) return {node};
    if (array->empty()) table.fail(key, "at least one value");
    for (const toml::node& value : *array)
        values.push_back(&value);
    return values;
}

bool toInt(std::string_view text, int& value) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size();
}

/// A whole number, or a text "A..B" that stands for all from A to B.
bool appendWhole(const toml::node& node, int min, int max, std::vector<int>& values) {
    int first = 0, last = 0;
    if (const auto* number = node.as_integer()) {
        if (number->get() < min || number->get() > max) return false;
        first = last = int(number->get());
    } else if (const auto* text = node.as_string()) {
        const std::string_view range = text->get();
        const std::size_t dots = range.find("..");
        if (dots == std::string_view::npos || !toInt(range.substr(0, dots), first) ||
            !toInt(range.substr(dots + 2), last))
            return false;
    } else {
        return false;
    }
    if (first < min || last > max || first > last) return false;
    for (int value = first; value <= last; ++value)
        values.push_back(value);
    return values.size() <= maxValues;
}

void readWholes(TomlTable& table, std::string_view key, int max, std::vector<int>& values) {
    for (const toml::node* node : valuesOf(table, key))
        if (!appendWhole(*node, 1, max, values))
            table.fail(key,
                       fmt::format("whole numbers from 1 to {}, or ranges of them such as \"3..101\"", max));
}

void readGrids(TomlTable& table, std::vector<glm::ivec2>& grids) {
    const int maxGrid = mostOf(waterKeys, &Water::grid);
    for (const toml::node* node : valuesOf(table, "grids")) {
        std::vector<int> pair;
        const toml::array* array = node->as_array();
        bool good = array && array->size() == 2;
        for (std::size_t i = 0; good && i < 2; ++i)
            good = array->get(i)->is_integer() && appendWhole(*array->get(i), 1, maxGrid, pair);
        if (!good) table.fail("grids", fmt::format("a list of pairs of whole numbers from 1 to {}", maxGrid));
        grids.emplace_back(pair[0], pair[1]);
    }
}

std::vector<std::string> readTexts(TomlTable& table, std::string_view key, std::string_view expected) {
    std::vector<std::string> texts;
    for (const toml::node* node : valuesOf(table, key)) {
        if (!node->is_string()) table.fail(key, std::string(expected));
        texts.push_back(node->as_string()->get());
    }
    return texts;
}

Method methodOf(TomlTable& table, std::string_view key, const std::string& name) {
    if (const std::optional<Method> method = methodFromName(name)) return *method;
    std::vector<std::string_view> known;
    for (const Method method : allMethods())
        known.push_back(methodName(method));
    throw InputError(fmt::format("{}expected methods of {}, found \"{}\"", table.where(key),
                                 fmt::join(known, ", "), oneLine(name)));
}

Fill fillNamed(TomlTable& table, std::string_view key, const std::string& name) {
    if (const std::optional<Fill> fill = fillFromName(name)) return *fill;
    std::vector<std::string_view> known;
    for (const Fill fill : allFills())
        known.push_back(fillName(fill));
    throw InputError(fmt::format("{}expected fills of {}, found \"{}\"", table.where(key),
                                 fmt::join(known, ", "), oneLine(name)));
}

/// Fit for a file's name.
std::string nameOf(const fs::path& model) {
    std::string name = model.stem().string().substr(0, 100);
    for (char& c : name)
        if (!isName(std::string{'a', c})) c = '-';
    return isName(name) ? name : "model";
}

/// A value as a scene's override has it.
template <typename Value>
std::string inlineToml(const Value& value) {
    std::ostringstream text;
    text << value;
    return text.str();
}

std::string receiverToml(toml::table&& receiver) {
    receiver.is_inline(true);
    toml::array list;
    list.push_back(std::move(receiver));
    return inlineToml(list);
}

/// What a scene says in `[godrays]`, once for each way to be measured.
void readGodrays(TomlTable& table, std::vector<std::string>& godrays) {
    for (const toml::node* node : valuesOf(table, "godrays")) {
        const toml::table* entry = node->as_table();
        if (!entry) table.fail("godrays", "tables as a scene has them");
        toml::table copy = *entry;
        copy.is_inline(true);
        godrays.push_back(inlineToml(copy));
    }
}

void readReceivers(TomlTable& table, const fs::path& folder, std::vector<ProfileReceiver>& receivers) {
    for (const toml::node* node : valuesOf(table, "receivers")) {
        if (const auto* path = node->as_string()) {
            for (ProfileReceiver& receiver : modelReceivers(folder / path->get()))
                receivers.push_back(std::move(receiver));
        } else if (const toml::table* shape = node->as_table()) {
            const std::string name = (*shape)["name"].value_or(std::string());
            if (!isName(name)) table.fail("receivers", "tables with a name, as a scene has them");
            receivers.push_back({name, receiverToml(toml::table(*shape)), false});
        } else {
            table.fail("receivers", "models, folders of models, or tables as a scene has them");
        }
    }
    for (std::size_t i = 0; i < receivers.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (receivers[i].name == receivers[j].name)
                throw InputError(
                    fmt::format("{}expected receivers of different names, found two named \"{}\"",
                                table.where("receivers"), receivers[i].name));
}

void readSettings(TomlTable& table, std::vector<Override>& settings) {
    for (const std::string& text : readTexts(table, "set", "texts of the form KEY=VALUE")) {
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos || equals == 0) table.fail("set", "texts of the form KEY=VALUE");
        settings.push_back({text.substr(0, equals), text.substr(equals + 1)});
    }
}

void readThesis(TomlTable& root, const fs::path& folder, Profile& profile) {
    std::optional<TomlTable> table = root.table("thesis");
    if (!table) return;
    std::string seconds, planes;
    table->text("seconds", seconds, "the path of a table");
    table->text("actual_planes", planes, "the path of a table");
    table->finish();
    if (!seconds.empty()) profile.seconds = loadPrintedTable(folder / seconds);
    if (!planes.empty()) profile.actualPlanes = loadPrintedTable(folder / planes);
}

int readWhole(TomlTable& table, std::string_view key, int value, int min, int max) {
    std::int64_t number = value;
    table.wholeNumber(key, number, min, max);
    return int(number);
}

void readScenes(TomlTable& table, const fs::path& folder, Profile& profile) {
    for (const char* key : {"scene", "scenes"})
        for (const std::string& scene : readTexts(table, key, "paths of scenes or models"))
            profile.scenes.push_back(folder / scene);
    if (profile.scenes.empty()) table.fail("scene", "the path of a scene or model");
}

} // namespace

std::vector<ProfileReceiver> modelReceivers(const fs::path& modelOrFolder) {
    std::vector<fs::path> models;
    if (fs::is_directory(modelOrFolder)) {
        for (const auto& entry : fs::directory_iterator(modelOrFolder))
            if (lowerCaseSuffix(entry.path()) == ".glb") models.push_back(entry.path());
        std::sort(models.begin(), models.end());
        if (models.empty())
            throw InputError(fmt::format("{}: expected models (.glb) in the folder, found none",
                                         oneLine(modelOrFolder.string())));
    } else {
        requireFile(modelOrFolder);
        models.push_back(modelOrFolder);
    }
    std::vector<ProfileReceiver> receivers;
    for (const fs::path& model : models) {
        const std::string name = nameOf(model);
        toml::table table;
        table.insert("name", name);
        table.insert("gltf", fs::absolute(model).lexically_normal().string());
        receivers.push_back({name, receiverToml(std::move(table)), true});
    }
    return receivers;
}

Profile loadProfile(const fs::path& file) {
    const std::vector<std::uint8_t> bytes = readBytes(file);
    const std::string fileName = file.string();
    const toml::table root = parseToml({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, fileName);
    const fs::path folder = file.parent_path();
    TomlTable table(root, "", fileName);
    Profile profile;
    profile.name = nameOf(file);
    readScenes(table, folder, profile);
    for (const std::string& name : readTexts(table, "methods", "names of methods"))
        profile.methods.push_back(methodOf(table, "methods", name));
    for (const std::string& name : readTexts(table, "fills", "names of fills"))
        profile.fills.push_back(fillNamed(table, "fills", name));
    readWholes(table, "planes", mostOf(causticsKeys, &CausticsSettings::planes), profile.planes);
    readWholes(table, "map_sizes", mostOf(causticsKeys, &CausticsSettings::mapSize), profile.mapSizes);
    readGrids(table, profile.grids);
    readGodrays(table, profile.godrays);
    readSettings(table, profile.settings);
    profile.warmup = readWhole(table, "warmup", profile.warmup, 0, 1000);
    profile.frames = readWhole(table, "frames", profile.frames, 1, 100000);
    table.wholeNumber("reference", profile.reference, 0, 1000000000000);
    table.flag("reuse", profile.reuse);
    if (std::string name; table.has("baseline")) {
        table.text("baseline", name, "the name of a method");
        profile.baseline = methodOf(table, "baseline", name);
        if (std::find(profile.methods.begin(), profile.methods.end(), profile.baseline) ==
            profile.methods.end())
            table.fail("baseline", "one of the methods that are run");
    }
    table.number("time", profile.time, {.min = -1e9, .max = 1e9});
    std::int64_t picture[2] = {profile.picture.x, profile.picture.y};
    table.wholeNumbers("picture", picture, 1, 7680);
    profile.picture = {int(picture[0]), int(picture[1])};
    readReceivers(table, folder, profile.receivers);
    readThesis(table, folder, profile);
    table.finish(" of a profile");
    return profile;
}

PrintedTable loadPrintedTable(const fs::path& file) {
    const std::vector<std::uint8_t> bytes = readBytes(file);
    std::istringstream stream(std::string(bytes.begin(), bytes.end()));
    PrintedTable table;
    int number = 0;
    bool named = false;
    for (std::string line; std::getline(stream, line);) {
        ++number;
        const auto fail = [&](const std::string& expected) {
            throw InputError(fmt::format("{}:{}: expected {}, found \"{}\"", oneLine(file.string()), number,
                                         expected, oneLine(line, 60)));
        };
        if (line.empty() || line.front() == '#') continue;
        std::vector<std::string> cells;
        std::istringstream row(line);
        for (std::string cell; std::getline(row, cell, '\t');)
            cells.push_back(cell);
        if (!named) {
            if (cells.front() != "planes") fail("the columns' names, planes first");
            for (std::size_t i = 1; i < cells.size(); ++i) {
                const std::size_t space = cells[i].find(' ');
                if (space == std::string::npos) fail("columns named RECEIVER METHOD");
                table.columns.push_back({cells[i].substr(0, space), cells[i].substr(space + 1), {}});
            }
            named = true;
            continue;
        }
        int planes = 0;
        if (cells.size() != table.columns.size() + 1 || !toInt(cells.front(), planes))
            fail(fmt::format("a whole number and {} numbers", table.columns.size()));
        table.planes.push_back(planes);
        for (std::size_t i = 0; i < table.columns.size(); ++i) {
            double value = 0;
            const std::string& cell = cells[i + 1];
            const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
            if (error != std::errc() || end != cell.data() + cell.size())
                fail(fmt::format("a whole number and {} numbers", table.columns.size()));
            table.columns[i].values.push_back(value);
        }
    }
    return table;
}

} // namespace limpid::io
