#pragma once
#include <filesystem>
#include <string>

#include <tiny_gltf.h>

namespace limpid::io {

/// A parsed glTF file. tinygltf checks its JSON only: every index, offset and count in `model` is still the
/// file's own claim. Images hold encoded bytes (data URIs and files) or name a buffer view, none is decoded.
/// What was compressed stands in buffers, views and accessors of its own behind the file's.
struct GltfFile {
    std::string name; ///< for errors
    tinygltf::Model model;
    std::size_t size = 0;         ///< bytes of the file and its buffers: what its claims are measured against
    std::size_t decompressed = 0; ///< bytes that `claimDecompressed` has let pass

    /// Throws InputError "NAME: PLACE: expected …, found …".
    [[noreturn]] void fail(const std::string& place, const std::string& expected,
                           const std::string& found) const;

    /// Throws InputError unless `index` is one of `count` things.
    void requireIndex(const std::string& place, int index, std::size_t count) const;

    /// To be asked before memory is given to compressed data. Throws InputError if all that the file makes of
    /// itself is more than a file of its size has reason to.
    void claimDecompressed(const std::string& place, std::size_t bytes);

    /// Adds a buffer with a view of all of it, and gives the view's index.
    int addBuffer(std::vector<unsigned char> data);
};

/// Parses a .glb or .gltf file, whichever its content is, and rejects what this loader does not support.
/// Buffer views and primitives that are compressed come out decompressed.
/// Files that it refers to are read only from its own folder and below. Throws InputError.
GltfFile readGltfFile(const std::filesystem::path& file);

} // namespace limpid::io
