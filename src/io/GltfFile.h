#pragma once
#include <filesystem>
#include <string>

#include <tiny_gltf.h>

namespace limpid::io {

/// A parsed glTF file. tinygltf checks its JSON only: every index, offset and count in `model` is still the
/// file's own claim. Images hold encoded bytes (data URIs and files) or name a buffer view, none is decoded.
struct GltfFile {
    std::string name; ///< for errors
    tinygltf::Model model;
    std::size_t size = 0; ///< bytes of the file and of its buffers: what its claims are measured against

    /// Throws InputError "NAME: PLACE: expected …, found …".
    [[noreturn]] void fail(const std::string& place, const std::string& expected,
                           const std::string& found) const;

    /// Throws InputError unless `index` is one of `count` things.
    void requireIndex(const std::string& place, int index, std::size_t count) const;
};

/// Parses a .glb or .gltf file, whichever its content is, and rejects what this loader does not support.
/// Files that it refers to are read only from its own folder and below. Throws InputError.
GltfFile readGltfFile(const std::filesystem::path& file);

} // namespace limpid::io
