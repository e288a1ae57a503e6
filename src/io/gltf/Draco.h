#pragma once
#include "io/gltf/File.h"

namespace limpid::io {

/// Decompresses every primitive with KHR_draco_mesh_compression: its attributes and indices then are
/// accessors of their own. Throws InputError.
void decodeDraco(GltfFile& file);

} // namespace limpid::io
