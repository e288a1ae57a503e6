#include "io/toml/TomlPatch.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

namespace limpid::io {

namespace {

/// A stretch of the text and what takes its place.
struct Edit {
    std::size_t begin = 0, end = 0; ///< bytes
    std::string replacement;
};

std::string applied(std::string text, std::vector<Edit> edits) {
    // From the end, so that places stay; at one place what goes before what comes.
    std::stable_sort(edits.begin(), edits.end(), [](const Edit& a, const Edit& b) {
        return a.begin != b.begin ? a.begin > b.begin : a.end > b.end;
    });
    for (const Edit& edit : edits)
        text.replace(edit.begin, edit.end - edit.begin, edit.replacement);
    return text;
}

/// Where lines begin, and where the library's places are in bytes.
class Lines {
  public:
    explicit Lines(const std::string& text) : _text(text) {
        for (std::size_t i = 0; i < text.size(); ++i)
            if (text[i] == '\n') _begins.push_back(i + 1);
    }
    std::size_t begin(std::size_t line) const {
        return line >= 1 && line <= _begins.size() ? _begins[line - 1] : _text.size();
    }
    /// Columns count characters, which are several bytes in UTF-8.
    std::size_t offset(const toml::source_position& place) const {
        std::size_t at = begin(place.line);
        for (std::size_t column = 1; column < place.column && at < _text.size(); ++column) {
            ++at;
            while (at < _text.size() && (static_cast<unsigned char>(_text[at]) & 0xC0) == 0x80)
                ++at;
        }
        return at;
    }

  private:
    const std::string& _text;
    std::vector<std::size_t> _begins{0};
};

/// The table of a setting; null if there is none.
const toml::table* tableOf(const toml::table& root, const Setting& setting) {
    const toml::node* node = root.at_path(setting.section).node();
    if (node && setting.entry >= 0) {
        const toml::array* entries = node->as_array();
        node = entries ? entries->get(std::size_t(setting.entry)) : nullptr;
    }
    return node ? node->as_table() : nullptr;
}

/// Whether the table has a header of its own in the text: `[section]` or `[[section]]`.
bool hasHeader(const std::string& text, const Lines& lines, const toml::table& table) {
    if (!table.source().begin) return false;
    const std::size_t at = lines.offset(table.source().begin);
    return !table.is_inline() && at < text.size() && text[at] == '[';
}

/// The last line that any value of the table ends in.
std::size_t lastLine(const toml::node& node) {
    std::size_t last = std::max(node.source().begin.line, node.source().end.line);
    if (const toml::table* table = node.as_table())
        for (const auto& [key, value] : *table)
            last = std::max(last, lastLine(value));
    return last;
}

} // namespace

std::string patchSettings(const std::string& text, const toml::table& root,
                          const std::vector<Setting>& settings) {
    const Lines lines(text);
    std::vector<Edit> edits;
    std::map<std::string, std::string> added; // to sections that are not there yet
    for (const Setting& setting : settings) {
        const toml::table* table = tableOf(root, setting);
        const std::string line = fmt::format("{} = {}\n", setting.key, setting.value);
        const toml::node* value = table ? table->get(setting.key) : nullptr;
        if (setting.value.empty()) {
            if (value && !table->is_inline())
                edits.push_back(
                    {lines.begin(value->source().begin.line), lines.begin(lastLine(*value) + 1), ""});
        } else if (value) {
            edits.push_back(
                {lines.offset(value->source().begin), lines.offset(value->source().end), setting.value});
        } else if (table && hasHeader(text, lines, *table)) {
            // Below the header's line, which the last of a file may be without an end.
            const std::size_t at = lines.begin(table->source().begin.line + 1);
            const bool open = at == text.size() && !text.empty() && text.back() != '\n';
            edits.push_back({at, at, open ? "\n" + line : line});
        } else if (setting.entry < 0) {
            added[setting.section] += line;
        }
    }
    std::string result = applied(text, edits);
    if (!result.empty() && result.back() != '\n') result += '\n';
    for (const auto& [section, keys] : added)
        result += fmt::format("\n[{}]\n{}", section, keys);
    return result;
}

std::string replaceWaves(const std::string& text, const toml::table& root, const std::string& waves) {
    const Lines lines(text);
    std::vector<Edit> edits;
    const toml::table* water = root["water"].as_table();
    if (const toml::node* preset = water ? water->get("preset") : nullptr) {
        const std::size_t line = preset->source().begin.line;
        edits.push_back({lines.begin(line), lines.begin(line + 1), ""});
    }
    const toml::array* entries = water ? (*water)["wave"].as_array() : nullptr;
    for (std::size_t i = 0; entries && i < entries->size(); ++i) {
        const toml::node& entry = *entries->get(i);
        edits.push_back(
            {lines.begin(entry.source().begin.line), lines.begin(lastLine(entry) + 1), i == 0 ? waves : ""});
    }
    if (entries && !entries->empty()) return applied(text, edits);
    std::string result = applied(text, edits);
    if (!result.empty() && result.back() != '\n') result += '\n';
    return result + (waves.empty() ? "" : "\n" + waves);
}

} // namespace limpid::io
