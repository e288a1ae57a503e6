#pragma once
#include <map>
#include <optional>
#include <string>

#include "io/gltf/Accessor.h"

namespace limpid::io {

/// Which accessors may serve as which attribute.
AccessorKind vectorKind(); ///< positions, and differences of positions and normals
AccessorKind normalKind();
AccessorKind uvKind();
AccessorKind colorKind();
AccessorKind colorDifferenceKind(); ///< what a morph target adds
AccessorKind weightKind();

/// An attribute of the primitive at `place`, none if it has no such. Throws InputError.
std::optional<AccessorView> findAttribute(const GltfFile& file, const std::string& place,
                                          const std::map<std::string, int>& attributes,
                                          const std::string& name, const AccessorKind& kind);

/// A further attribute, which must reach as far as the positions do. Throws InputError.
std::optional<AccessorView> findAttribute(const GltfFile& file, const std::string& place,
                                          const std::map<std::string, int>& attributes,
                                          const std::string& name, const AccessorKind& kind,
                                          std::size_t count);

} // namespace limpid::io
