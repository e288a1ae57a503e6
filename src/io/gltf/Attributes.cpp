#include "io/gltf/Attributes.h"

#include <fmt/format.h>

namespace limpid::io {

AccessorKind vectorKind() {
    return {{TINYGLTF_TYPE_VEC3},
            {TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_COMPONENT_TYPE_BYTE,
             TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, TINYGLTF_COMPONENT_TYPE_SHORT,
             TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT},
            "vectors of 3 floats, or of 3 integers of 8 or 16 bits"};
}

AccessorKind normalKind() {
    return {{TINYGLTF_TYPE_VEC3},
            {TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_COMPONENT_TYPE_BYTE, TINYGLTF_COMPONENT_TYPE_SHORT},
            "vectors of 3 floats, or of 3 integers of 8 or 16 bits with sign"};
}

AccessorKind uvKind() {
    return {{TINYGLTF_TYPE_VEC2},
            vectorKind().componentTypes,
            "vectors of 2 floats, or of 2 integers of 8 or 16 bits"};
}

AccessorKind colorKind() {
    return {{TINYGLTF_TYPE_VEC3, TINYGLTF_TYPE_VEC4},
            {TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE,
             TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT},
            "vectors of 3 or 4 floats, or of 3 or 4 integers of 8 or 16 bits without sign"};
}

AccessorKind colorDifferenceKind() {
    return {colorKind().types, vectorKind().componentTypes,
            "vectors of 3 or 4 floats, or of 3 or 4 integers of 8 or 16 bits"};
}

AccessorKind weightKind() {
    return {{TINYGLTF_TYPE_VEC4},
            colorKind().componentTypes,
            "vectors of 4 floats, or of 4 integers of 8 or 16 bits without sign"};
}

std::optional<AccessorView> findAttribute(const GltfFile& file, const std::string& place,
                                          const std::map<std::string, int>& attributes,
                                          const std::string& name, const AccessorKind& kind) {
    const auto found = attributes.find(name);
    if (found == attributes.end()) return std::nullopt;
    return AccessorView(file, fmt::format("{}.attributes.{}", place, name), found->second, kind);
}

std::optional<AccessorView> findAttribute(const GltfFile& file, const std::string& place,
                                          const std::map<std::string, int>& attributes,
                                          const std::string& name, const AccessorKind& kind,
                                          std::size_t count) {
    std::optional<AccessorView> view = findAttribute(file, place, attributes, name, kind);
    if (view && view->count() < count)
        file.fail(fmt::format("{}.attributes.{}", place, name),
                  fmt::format("{} elements, as POSITION has", count), fmt::format("{}", view->count()));
    return view;
}

} // namespace limpid::io
