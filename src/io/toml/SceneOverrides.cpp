#include "io/toml/SceneOverrides.h"

#include <algorithm>
#include <charconv>
#include <string_view>

#include <fmt/format.h>

#include "core/Error.h"
#include "io/Files.h"
#include "io/toml/TomlReader.h"

namespace limpid::io {

namespace {

/// How far the walk along an override's key has come.
struct Walk {
    toml::table* table;
    std::string_view rest;   ///< of the key
    std::string_view source; ///< `--set KEY=VALUE`
};

std::string tomlString(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\')
            result += fmt::format("\\{}", c);
        else if (static_cast<unsigned char>(c) < ' ' || c == '\x7f')
            result += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        else
            result += c;
    }
    return result + '"';
}

/// A table that holds the override's value under "value", its source set to `source`.
toml::table parseValue(const std::string& text, const std::string& source) {
    try {
        toml::table table = parseToml(fmt::format("value = {}", text), source);
        if (table.size() == 1 && table.contains("value")) return table;
    } catch (const InputError&) {
        // A bare word: taken as a string below.
    }
    return parseToml(fmt::format("value = {}", tomlString(text)), source);
}

std::string_view takeSegment(std::string_view& rest) {
    const std::size_t dot = rest.find('.');
    const std::string_view segment = rest.substr(0, dot);
    rest = dot == std::string_view::npos ? std::string_view() : rest.substr(dot + 1);
    return segment;
}

std::string entryName(const toml::array& array, std::size_t i, std::string_view kind) {
    const auto name = array.get(i)->is_table() ? (*array.get(i)->as_table())["name"].value<std::string>()
                                               : std::optional<std::string>();
    if (name) return *name;
    return kind == "wave" ? std::to_string(i) : fmt::format("{}{}", kind, i);
}

std::string listEntries(const toml::array& array, std::string_view kind) {
    if (array.empty()) return "there are none";
    std::string names;
    for (std::size_t i = 0; i < array.size(); ++i)
        names += (i == 0 ? "" : ", ") + entryName(array, i, kind);
    return "there are " + oneLine(names, 400);
}

[[noreturn]] void failEntry(const Walk& walk, std::string_view kind, const toml::array& array) {
    throw InputError(fmt::format("{}: expected the name or number of a {} ({}), found \"{}\"", walk.source,
                                 kind, listEntries(array, kind), walk.rest.substr(0, walk.rest.find('.'))));
}

/// Steps into the entry that `walk.rest` begins with: the longest name that fits, as names may hold dots,
/// else a number.
void enterEntry(Walk& walk, toml::array& array, std::string_view kind) {
    std::size_t best = array.size(), bestLength = 0;
    for (std::size_t i = 0; i < array.size(); ++i) {
        const std::string name = entryName(array, i, kind);
        if (name.size() > bestLength && walk.rest.starts_with(name + '.')) best = i, bestLength = name.size();
    }
    std::string_view rest = walk.rest;
    const std::string_view segment = takeSegment(rest);
    if (best == array.size()) {
        const auto [end, error] = std::from_chars(segment.data(), segment.data() + segment.size(), best);
        if (error != std::errc() || end != segment.data() + segment.size()) best = array.size();
        bestLength = segment.size();
    }
    if (best >= array.size() || !array.get(best)->is_table()) failEntry(walk, kind, array);
    walk.table = array.get(best)->as_table();
    walk.rest = walk.rest.substr(std::min(bestLength + 1, walk.rest.size()));
}

/// Steps into the table, or the entry of an array of tables, that `walk.rest` begins with.
void enter(Walk& walk, std::string& path) {
    const std::string key(takeSegment(walk.rest));
    path += (path.empty() ? "" : ".") + key;
    toml::node* child = walk.table->get(key);
    if (!child && isListed(path)) failEntry(walk, key, toml::array{});
    if (!child) child = &walk.table->insert_or_assign(key, toml::table{}).first->second;
    if (toml::array* array = child->as_array(); array && isListed(path))
        enterEntry(walk, *array, key);
    else if (child->is_table())
        walk.table = child->as_table();
    else
        throw InputError(fmt::format("{}: unknown key, {} is no table", walk.source, oneLine(path)));
}

void applyOverride(toml::table& root, const Override& override) {
    const std::string source = oneLine(fmt::format("{}{}={}", overridePrefix, override.key, override.value));
    // Each part may become a table in a table, which are freed by recursion; names may have 50 dots.
    if (std::count(override.key.begin(), override.key.end(), '.') > 200)
        throw InputError(fmt::format("{}: expected a key of fewer parts", source));
    Walk walk{&root, override.key, source};
    std::string path;
    while (walk.rest.find('.') != std::string_view::npos)
        enter(walk, path);
    if (walk.rest.empty())
        throw InputError(fmt::format("{}: expected the dotted key of a value, found \"{}\"", source,
                                     oneLine(override.key)));
    toml::table value = parseValue(override.value, source);
    walk.table->insert_or_assign(walk.rest, std::move(value.begin()->second));
}

} // namespace

void applyOverrides(toml::table& root, const std::vector<Override>& overrides) {
    for (const Override& override : overrides)
        applyOverride(root, override);
}

} // namespace limpid::io
