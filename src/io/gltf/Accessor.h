#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "io/gltf/File.h"

namespace limpid::io {

/// What an accessor has to be to serve a purpose.
struct AccessorKind {
    std::vector<int> types;          ///< TINYGLTF_TYPE_…
    std::vector<int> componentTypes; ///< TINYGLTF_COMPONENT_TYPE_…
    const char* text;                ///< completes "expected …"
};

/// `count` elements in a buffer, every one of them inside.
struct ElementRange {
    const std::uint8_t* first = nullptr; ///< null: all elements are zero
    std::size_t stride = 0;
    std::size_t count = 0;
};

/// The bytes of a buffer view, checked. Throws InputError.
std::span<const std::uint8_t> bufferViewBytes(const GltfFile& file, const std::string& place, int bufferView);

/// Reads an accessor in place: nothing is allocated, whatever count it claims. Everything is checked on
/// construction (ranges, strides, types, the order of sparse indices). The file must outlive the view.
class AccessorView {
  public:
    /// `place` names what refers to the accessor. Throws InputError.
    AccessorView(const GltfFile& file, const std::string& place, int accessor, const AccessorKind& kind);

    std::size_t count() const { return _elements.count; }
    int components() const { return _components; }

    /// Component `c` of element `i`, normalised integers as [0, 1] or [−1, 1].
    double component(std::size_t i, int c) const;

    /// The first three of them.
    glm::dvec3 vec3(std::size_t i) const { return {component(i, 0), component(i, 1), component(i, 2)}; }

    std::uint32_t index(std::size_t i) const;

  private:
    void readSparse(const GltfFile& file, const tinygltf::Accessor& accessor);
    const std::uint8_t* element(std::size_t i) const;
    std::uint32_t sparseIndex(std::size_t k) const;

    std::string _place;
    int _components = 0;
    int _componentType = 0;
    std::size_t _componentSize = 0;
    std::size_t _elementSize = 0;
    bool _normalized = false;
    ElementRange _elements;
    ElementRange _sparseIndices;
    ElementRange _sparseValues;
    int _sparseIndexType = 0;
};

} // namespace limpid::io
