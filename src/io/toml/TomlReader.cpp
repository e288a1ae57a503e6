#include "io/toml/TomlReader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include <fmt/format.h>

#include "core/Error.h"
#include "io/Files.h"

namespace limpid::io {

namespace {

constexpr std::size_t maxDescription = 60; ///< bytes of a value that an error shows

void describeInto(const toml::node& node, std::string& text) {
    if (const toml::array* array = node.as_array()) {
        text += '[';
        for (std::size_t i = 0; i < array->size() && text.size() <= maxDescription; ++i) {
            if (i > 0) text += ", ";
            describeInto(*array->get(i), text);
        }
        text += ']';
    } else if (node.is_table()) {
        text += "a table";
    } else if (const auto* string = node.as_string()) {
        text += fmt::format("\"{}\"", string->get());
    } else if (const auto* number = node.as_floating_point()) {
        text += fmt::format("{}", number->get());
    } else {
        std::ostringstream stream;
        node.visit([&](const auto& value) { stream << value; });
        text += stream.str();
    }
}

std::size_t editDistance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j)
        row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i - 1] != b[j - 1]);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
        }
    }
    return row[b.size()];
}

std::string expectedWholes(std::size_t count, std::int64_t min, std::int64_t max) {
    return expectedNumbers(count, true, fmt::format(" from {} to {}", min, max));
}

/// Takes whole numbers too, as TOML writes 1 for 1.0.
bool toNumber(const toml::node& node, const Range& range, double& value) {
    if (!node.is_number()) return false;
    const double number = node.value<double>().value_or(NAN);
    if (!std::isfinite(number) || !anyNumber.contains(number) || !range.contains(number)) return false;
    value = number;
    return true;
}

bool toWholeNumber(const toml::node& node, std::int64_t min, std::int64_t max, std::int64_t& value) {
    const auto* number = node.as_integer();
    if (!number || number->get() < min || number->get() > max) return false;
    value = number->get();
    return true;
}

/// toml++ makes and frees tables in tables by recursion. It lets values nest 256 deep, but each of them may
/// bring a dotted key of any length; a scene has none of more than four parts.
constexpr int maxKeyParts = 64;

/// Past the string that begins at `at`; one that does not end is for the parser to find.
std::size_t skipString(std::string_view text, std::size_t at) {
    const std::string quotes(3, text[at]);
    const bool multiLine = text.substr(at, 3) == quotes, escapes = text[at] == '"';
    const std::string_view closing = std::string_view(quotes).substr(0, multiLine ? 3 : 1);
    for (at += closing.size(); at < text.size(); ++at) {
        if (escapes && text[at] == '\\') {
            ++at;
        } else if (text.substr(at, closing.size()) == closing) {
            at += closing.size();
            // Up to two quotes before the closing ones are the string's own.
            for (int more = 0; multiLine && more < 2 && at < text.size() && text[at] == quotes[0]; ++more)
                ++at;
            return at;
        } else if (!multiLine && text[at] == '\n') {
            return at;
        }
    }
    return text.size();
}

bool isKeyPart(char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_' ||
           c == '-' || c == ' ' || c == '\t';
}

void requireShortKeys(std::string_view text, const std::string& source) {
    int parts = 1;
    for (std::size_t at = 0; at < text.size();) {
        const char c = text[at];
        if (c == '"' || c == '\'') {
            at = skipString(text, at);
        } else if (c == '#') {
            at = std::min(text.find('\n', at), text.size());
        } else {
            if (c == '.')
                ++parts;
            else if (!isKeyPart(c))
                parts = 1;
            ++at;
        }
        if (parts > maxKeyParts)
            throw InputError(fmt::format(
                "{}:{}: expected keys of at most {} parts, found a longer one", oneLine(source),
                1 + std::count(text.begin(), text.begin() + std::ptrdiff_t(at), '\n'), maxKeyParts));
    }
}

/// A key of an override has no place of its own, and a table on its way there has neither; the value has.
const toml::source_region& firstSource(const toml::node& node) {
    const toml::table* table = node.as_table();
    if (node.source().path || !table || table->empty()) return node.source();
    return firstSource(table->begin()->second);
}

} // namespace

toml::table parseToml(std::string_view text, const std::string& source) {
    requireShortKeys(text, source);
    try {
        return toml::parse(text, source);
    } catch (const toml::parse_error& error) {
        throw InputError(fmt::format("{}: expected valid TOML, found an error: {}",
                                     placeOf(error.source(), source), oneLine(error.description())));
    }
}

std::string placeOf(const toml::source_region& source, const std::string& file) {
    if (!source.path || !source.begin) return oneLine(file);
    if (source.path->starts_with(overridePrefix)) return *source.path;
    return fmt::format("{}:{}:{}", oneLine(*source.path), source.begin.line, source.begin.column);
}

std::string describe(const toml::node* node) {
    if (!node) return "nothing";
    std::string text;
    describeInto(*node, text);
    return oneLine(text, maxDescription);
}

std::string suggestion(std::string_view key, const std::set<std::string, std::less<>>& known) {
    std::size_t least = 3;
    std::string nearest;
    for (const std::string& candidate : known) {
        // One slip in a short key, two in a longer one; more is no longer a slip.
        const std::size_t slips = candidate.size() < 5 ? 1 : 2;
        const std::size_t distance = key.size() < 64 ? editDistance(key, candidate) : least;
        if (distance <= slips && distance < least) least = distance, nearest = candidate;
    }
    return nearest.empty() ? "" : fmt::format(", did you mean \"{}\"?", nearest);
}

const toml::node* TomlTable::find(std::string_view key) {
    _known.emplace(key);
    return _table.get(key);
}

bool TomlTable::has(std::string_view key) {
    return find(key) != nullptr;
}

std::string TomlTable::pathOf(std::string_view key) const {
    if (key.empty()) return _path;
    return _path.empty() ? std::string(key) : fmt::format("{}.{}", _path, key);
}

std::string TomlTable::where(std::string_view key) const {
    const toml::node* node = _table.get(key);
    const std::string place =
        placeOf((node ? *node : static_cast<const toml::node&>(_table)).source(), _file);
    const std::string path = pathOf(key);
    // An override already names its key.
    if (path.empty() || place.starts_with(fmt::format("{}{}=", overridePrefix, path))) return place + ": ";
    return fmt::format("{}: {}: ", place, oneLine(path));
}

void TomlTable::fail(std::string_view key, const std::string& expected) const {
    throw InputError(fmt::format("{}expected {}, found {}", where(key), expected, describe(_table.get(key))));
}

void TomlTable::number(std::string_view key, double& value, const Range& range) {
    const toml::node* node = find(key);
    if (node && !toNumber(*node, range, value)) fail(key, expectedNumbers(1, false, range.text()));
}

void TomlTable::numbers(std::string_view key, std::span<double> values, const Range& range) {
    const toml::node* node = find(key);
    if (!node) return;
    const toml::array* array = node->as_array();
    bool good = array && array->size() == values.size();
    for (std::size_t i = 0; good && i < values.size(); ++i)
        good = toNumber(*array->get(i), range, values[i]);
    if (!good) fail(key, expectedNumbers(values.size(), false, range.text()));
}

void TomlTable::wholeNumber(std::string_view key, std::int64_t& value, std::int64_t min, std::int64_t max) {
    const toml::node* node = find(key);
    if (node && !toWholeNumber(*node, min, max, value)) fail(key, expectedWholes(1, min, max));
}

void TomlTable::wholeNumbers(std::string_view key, std::span<std::int64_t> values, std::int64_t min,
                             std::int64_t max) {
    const toml::node* node = find(key);
    if (!node) return;
    const toml::array* array = node->as_array();
    bool good = array && array->size() == values.size();
    for (std::size_t i = 0; good && i < values.size(); ++i)
        good = toWholeNumber(*array->get(i), min, max, values[i]);
    if (!good) fail(key, expectedWholes(values.size(), min, max));
}

void TomlTable::text(std::string_view key, std::string& value, std::string_view expected) {
    const toml::node* node = find(key);
    if (!node) return;
    if (!node->is_string()) fail(key, std::string(expected));
    value = node->as_string()->get();
}

void TomlTable::texts(std::string_view key, std::vector<std::string>& values, std::string_view expected) {
    const toml::node* node = find(key);
    if (!node) return;
    if (!node->is_array()) fail(key, std::string(expected));
    values.clear();
    for (const toml::node& entry : *node->as_array()) {
        if (!entry.is_string()) fail(key, std::string(expected));
        values.push_back(entry.as_string()->get());
    }
}

void TomlTable::flag(std::string_view key, bool& value) {
    const toml::node* node = find(key);
    if (!node) return;
    if (!node->is_boolean()) fail(key, "true or false");
    value = node->as_boolean()->get();
}

void TomlTable::choice(std::string_view key, std::size_t& value, const Choice& names) {
    const toml::node* node = find(key);
    if (!node) return;
    const auto* string = node->as_string();
    std::vector<std::string_view> all(names.names.begin(), names.names.end());
    const auto found = std::find(all.begin(), all.end(), string ? string->get() : std::string());
    if (found == all.end()) {
        std::rotate(all.begin(), all.begin() + std::ptrdiff_t(value),
                    all.begin() + std::ptrdiff_t(value) + 1);
        fail(key, eitherOf(all, '"') + std::string(names.remark));
    }
    value = std::size_t(found - all.begin());
}

std::optional<TomlTable> TomlTable::table(std::string_view key) {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    if (!node->is_table()) fail(key, "a table");
    return TomlTable(*node->as_table(), pathOf(key), _file);
}

std::vector<TomlTable> TomlTable::tables(std::string_view key, std::size_t limit) {
    std::vector<TomlTable> entries;
    const toml::node* node = find(key);
    if (!node) return entries;
    const toml::array* array = node->as_array();
    if (!array) fail(key, fmt::format("an array of tables, [[{}]]", pathOf(key)));
    if (array->size() > limit)
        throw InputError(
            fmt::format("{}expected at most {} entries, found {}", where(key), limit, array->size()));
    for (std::size_t i = 0; i < array->size(); ++i) {
        const toml::table* entry = array->get(i)->as_table();
        if (!entry) fail(key, fmt::format("an array of tables, [[{}]]", pathOf(key)));
        const auto name = (*entry)["name"].value<std::string>();
        entries.emplace_back(*entry, fmt::format("{}.{}", pathOf(key), name ? *name : std::to_string(i)),
                             _file);
    }
    return entries;
}

void TomlTable::finish(std::string_view kind) const {
    for (const auto& [key, node] : _table) {
        if (_known.contains(key.str())) continue;
        const std::string place = placeOf(key.source().path ? key.source() : firstSource(node), _file);
        const bool named = place.starts_with(overridePrefix);
        std::string hint = suggestion(key.str(), _known);
        if (hint.empty()) {
            for (const std::string& known : _known)
                hint += (hint.empty() ? ", expected one of " : ", ") + known;
        }
        throw InputError(fmt::format("{}: {}unknown key{}{}", place,
                                     named ? "" : oneLine(pathOf(key.str())) + ": ", kind, hint));
    }
}

} // namespace limpid::io
