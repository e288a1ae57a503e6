#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace limpid::io {

/// glTF's JSON with its URIs escaped such that tinygltf decodes them by RFC 3986; none if they are already,
/// or if it is no JSON. tinygltf takes `+` for a space, and `%` for an escape whatever follows it.
std::optional<std::string> withEscapedUris(std::string_view json);

/// The file of a decoded URI in the model's folder. Backslashes, which some exporters write, part folders
/// unless a file's name holds them.
std::filesystem::path fileOfUri(const std::filesystem::path& folder, const std::string& uri);

} // namespace limpid::io
