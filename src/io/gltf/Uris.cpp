#include "io/gltf/Uris.h"

#include <algorithm>
#include <cctype>

#include <nlohmann/json.hpp>

namespace fs = std::filesystem;

namespace limpid::io {

namespace {

using nlohmann::json;

bool isData(std::string_view uri) {
    return uri.starts_with("data:");
}

/// False for nearly every file, whose JSON is then not parsed twice. Bytes within data URIs do not count.
bool mayNeedEscapes(std::string_view text) {
    constexpr std::string_view key = "\"uri\"";
    for (std::size_t at = text.find(key); at != std::string_view::npos; at = text.find(key, at + 1)) {
        const std::size_t begin = text.find('"', at + key.size());
        if (begin == std::string_view::npos) return false;
        const std::string_view value = text.substr(begin + 1, text.find('"', begin + 1) - begin - 1);
        if (!isData(value) && value.find_first_of("+%\\") != std::string_view::npos) return true;
    }
    return false;
}

bool startsEscape(std::string_view rest) {
    return rest.size() > 2 && rest[0] == '%' && std::isxdigit(static_cast<unsigned char>(rest[1])) &&
           std::isxdigit(static_cast<unsigned char>(rest[2]));
}

std::string escaped(std::string_view uri) {
    std::string result;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        if (uri[i] == '+')
            result += "%2B";
        else if (uri[i] == '%' && !startsEscape(uri.substr(i)))
            result += "%25";
        else
            result += uri[i];
    }
    return result;
}

/// True if a URI of an entry of `root[list]` was changed.
bool escapeUris(json& root, const char* list) {
    bool changed = false;
    if (!root.is_object() || !root.contains(list) || !root[list].is_array()) return false;
    for (json& entry : root[list]) {
        if (!entry.is_object() || !entry.contains("uri") || !entry["uri"].is_string()) continue;
        auto& uri = entry["uri"].get_ref<std::string&>();
        if (isData(uri) || escaped(uri) == uri) continue;
        uri = escaped(uri);
        changed = true;
    }
    return changed;
}

} // namespace

std::optional<std::string> withEscapedUris(std::string_view text) {
    if (!mayNeedEscapes(text)) return std::nullopt;
    json root = json::parse(text, nullptr, false);
    bool changed = escapeUris(root, "buffers");
    changed |= escapeUris(root, "images");
    if (!changed) return std::nullopt;
    return root.dump(-1, ' ', false, json::error_handler_t::replace);
}

fs::path fileOfUri(const fs::path& folder, const std::string& uri) {
    std::error_code ignored;
    std::string parted = uri;
    std::replace(parted.begin(), parted.end(), '\\', '/');
    return parted == uri || fs::exists(folder / uri, ignored) ? folder / uri : folder / parted;
}

} // namespace limpid::io
