#pragma once
#include <string_view>

#include "io/gltf/File.h"

namespace limpid::io {

/// Throws InputError with the name of an extension that the file requires and that changes more than looks
/// which are not drawn.
void checkRequiredExtensions(const GltfFile& file);

/// The reason why an extension, or a part of it, is not used; empty where all of it is.
std::string_view unusedReason(std::string_view extension);

/// The reason of all that only changes how light glances off a surface.
inline constexpr std::string_view mattReason = "all surfaces are drawn matt";

} // namespace limpid::io
