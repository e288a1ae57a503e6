#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>
#include <toml++/toml.h>

#include "scene/Keys.h"

/// Checked access to TOML tables: every error names file, line, column, key, what was expected and what was
/// found; a key that nobody asked for is an error.
namespace limpid::io {

/// What `--set KEY=VALUE` gave, as TOML keeps it: values of overrides carry it as their source.
inline constexpr std::string_view overridePrefix = "--set ";

/// Parses TOML text; `source` stands in for the file's name in errors.
toml::table parseToml(std::string_view text, const std::string& source);

/// The place of `node` for an error: `FILE:LINE:COLUMN`, `--set KEY=VALUE`, or `file` for a node made in
/// code.
std::string placeOf(const toml::source_region& source, const std::string& file);

/// `node` as an error shows it, in one line.
std::string describe(const toml::node* node);

/// `", did you mean "level"?"` if one of `known` is a slip of the pen away from `key`, else empty.
std::string suggestion(std::string_view key, const std::set<std::string, std::less<>>& known);

/// One table of a scene file. Each read leaves its target as it is if the key is absent; `finish` then
/// rejects the keys that were never read.
class TomlTable {
  public:
    /// `table` and `file` must outlive this. `path` is the table's own dotted key, empty for the root.
    TomlTable(const toml::table& table, std::string path, const std::string& file)
        : _table(table), _path(std::move(path)), _file(file) {}

    bool has(std::string_view key);

    /// For values that none of the reads below fits; null if the key is absent.
    const toml::node* value(std::string_view key) { return find(key); }

    void number(std::string_view key, double& value, const Range& range);
    void numbers(std::string_view key, std::span<double> values, const Range& range);
    void wholeNumber(std::string_view key, std::int64_t& value, std::int64_t min, std::int64_t max);
    void wholeNumbers(std::string_view key, std::span<std::int64_t> values, std::int64_t min,
                      std::int64_t max);
    void text(std::string_view key, std::string& value, std::string_view expected);

    /// `value`: the place of the key's text in the names. An error lists the default, which is `value`
    /// before, first.
    void choice(std::string_view key, std::size_t& value, const Choice& names);

    std::optional<TomlTable> table(std::string_view key);

    /// An array of tables; their paths end in the entry's name where it has one, else in its number.
    std::vector<TomlTable> tables(std::string_view key, std::size_t limit);

    /// A list of texts.
    void texts(std::string_view key, std::vector<std::string>& values, std::string_view expected);

    void flag(std::string_view key, bool& value);

    /// Throws InputError for the first key that was never asked for. `kind` completes "unknown key".
    void finish(std::string_view kind = {}) const;

    /// `expected`: "a number > 0", say. What was found is the key's value.
    [[noreturn]] void fail(std::string_view key, const std::string& expected) const;

    /// `KEY'S PLACE: KEY: ` to begin an error with.
    std::string where(std::string_view key) const;

  private:
    const toml::node* find(std::string_view key);
    std::string pathOf(std::string_view key) const;

    const toml::table& _table;
    std::string _path;
    const std::string& _file;
    std::set<std::string, std::less<>> _known;
};

} // namespace limpid::io
