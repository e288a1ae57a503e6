#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "io/gltf/File.h"

namespace limpid::io {

/// The vertices at the corners of a primitive's triangles, three for each triangle, counter-clockwise: from a
/// list, strip or fan, with or without indices. Triangles that use a vertex twice are left out, and so is an
/// incomplete one at the end. Empty for points and lines.
/// Throws InputError for an index that is not below `vertexCount`, or for more than `limit` corners.
std::vector<std::uint32_t> triangleCorners(const GltfFile& file, const std::string& place,
                                           const tinygltf::Primitive& primitive, std::size_t vertexCount,
                                           std::size_t limit);

} // namespace limpid::io
