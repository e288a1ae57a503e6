#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "io/gltf/File.h"

namespace limpid::io {

/// Compression leaves things out of a file that tinygltf insists on: the data of buffers that exist only once
/// they are decompressed, and the view of a Draco primitive's indices. Gives the JSON with a byte for the
/// former and without the latter, which Draco holds itself, or none if it needs no change or is no JSON.
std::optional<std::string> withoutCompressionGaps(std::string_view json);

/// An extension's object under that name, null if there is none.
const tinygltf::Value* extensionObject(const tinygltf::ExtensionMap& extensions, const char* name);

/// Member `key` of an extension's object, a whole number >= 0; 0 if it is not there and need not be.
/// Throws InputError.
std::size_t sizeMember(const GltfFile& file, const std::string& place, const tinygltf::Value& object,
                       const char* key, bool required);

/// The same for an index, -1 if it is not there. Not yet checked against anything.
int indexMember(const GltfFile& file, const std::string& place, const tinygltf::Value& object,
                const char* key);

} // namespace limpid::io
