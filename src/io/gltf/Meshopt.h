#pragma once
#include "io/gltf/File.h"

namespace limpid::io {

/// Decompresses every buffer view with EXT_meshopt_compression, or with KHR_meshopt_compression as far as it
/// is the same: streams of version 0. The views then show buffers of their own. Throws InputError.
void decodeMeshopt(GltfFile& file);

} // namespace limpid::io
