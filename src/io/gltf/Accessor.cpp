#include "io/gltf/Accessor.h"

#include <algorithm>
#include <cstring>

#include <fmt/format.h>

namespace limpid::io {

namespace {

/// An accessor without a buffer view is all zeros and could claim any count; no sensible file claims more
/// elements than this for each of its bytes.
constexpr std::size_t maxImpliedElementsPerByte = 1024;

template <typename T>
T load(const std::uint8_t* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value); // elements may lie unaligned
    return value;
}

std::uint32_t loadIndex(const std::uint8_t* bytes, int componentType) {
    if (componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) return *bytes;
    if (componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) return load<std::uint16_t>(bytes);
    return load<std::uint32_t>(bytes);
}

bool isIndexType(int componentType) {
    return componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
           componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
           componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

const char* typeName(int type) {
    switch (type) {
    case TINYGLTF_TYPE_SCALAR:
        return "SCALAR";
    case TINYGLTF_TYPE_VEC2:
        return "VEC2";
    case TINYGLTF_TYPE_VEC3:
        return "VEC3";
    case TINYGLTF_TYPE_VEC4:
        return "VEC4";
    default:
        return "a matrix";
    }
}

std::size_t componentSize(int componentType) {
    return static_cast<std::size_t>(
        tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(componentType)));
}

/// `count` elements of `size` bytes from `offset` of a buffer view on; `stride` 0 stands for `size`.
ElementRange elementRange(const GltfFile& file, const std::string& place, int bufferView, std::size_t offset,
                          std::size_t count, std::size_t size, std::size_t stride) {
    const std::span<const std::uint8_t> bytes = bufferViewBytes(file, place + ".bufferView", bufferView);
    if (stride == 0) stride = size;
    if (stride < size)
        file.fail(place + ".bufferView", fmt::format("a byteStride of at least {}", size),
                  fmt::format("{}", stride));
    if (offset > bytes.size())
        file.fail(place + ".byteOffset", fmt::format("at most {}", bytes.size()), fmt::format("{}", offset));
    const std::size_t room = bytes.size() - offset;
    const std::size_t fitting = room < size ? 0 : (room - size) / stride + 1;
    if (count > fitting)
        file.fail(place + ".count", fmt::format("at most {}, as its buffer view ends there", fitting),
                  fmt::format("{}", count));
    return {bytes.data() + offset, stride, count};
}

} // namespace

std::span<const std::uint8_t> bufferViewBytes(const GltfFile& file, const std::string& place,
                                              int bufferView) {
    const tinygltf::Model& model = file.model;
    file.requireIndex(place, bufferView, model.bufferViews.size());
    const std::string viewPlace = fmt::format("bufferViews[{}]", bufferView);
    const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(bufferView)];
    file.requireIndex(viewPlace + ".buffer", view.buffer, model.buffers.size());
    const auto& data = model.buffers[static_cast<std::size_t>(view.buffer)].data;
    if (view.byteOffset > data.size() || view.byteLength > data.size() - view.byteOffset)
        file.fail(viewPlace, fmt::format("a range inside of its buffer's {} bytes", data.size()),
                  fmt::format("{} bytes from {}", view.byteLength, view.byteOffset));
    return {data.data() + view.byteOffset, view.byteLength};
}

AccessorView::AccessorView(const GltfFile& file, const std::string& place, int index,
                           const AccessorKind& kind) {
    file.requireIndex(place, index, file.model.accessors.size());
    _place = fmt::format("accessors[{}]", index);
    const tinygltf::Accessor& accessor = file.model.accessors[static_cast<std::size_t>(index)];
    const auto isOneOf = [](const std::vector<int>& types, int type) {
        return std::find(types.begin(), types.end(), type) != types.end();
    };
    if (!isOneOf(kind.types, accessor.type) || !isOneOf(kind.componentTypes, accessor.componentType))
        file.fail(_place, fmt::format("{} for {}", kind.text, place),
                  fmt::format("{} of component type {}", typeName(accessor.type), accessor.componentType));
    _componentType = accessor.componentType;
    _componentSize = componentSize(_componentType);
    _components = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
    _elementSize = _componentSize * static_cast<std::size_t>(_components);
    _normalized = accessor.normalized;
    if (accessor.bufferView >= 0) {
        file.requireIndex(_place + ".bufferView", accessor.bufferView, file.model.bufferViews.size());
        const std::size_t stride =
            file.model.bufferViews[static_cast<std::size_t>(accessor.bufferView)].byteStride;
        _elements = elementRange(file, _place, accessor.bufferView, accessor.byteOffset, accessor.count,
                                 _elementSize, stride);
    } else {
        if (accessor.count / maxImpliedElementsPerByte > file.size)
            file.fail(_place + ".count",
                      fmt::format("at most {} without a buffer view", file.size * maxImpliedElementsPerByte),
                      fmt::format("{}", accessor.count));
        _elements.count = accessor.count;
    }
    if (accessor.sparse.isSparse) readSparse(file, accessor);
}

void AccessorView::readSparse(const GltfFile& file, const tinygltf::Accessor& accessor) {
    const auto& sparse = accessor.sparse;
    const std::string place = _place + ".sparse";
    if (sparse.count < 0 || static_cast<std::size_t>(sparse.count) > count())
        file.fail(place + ".count", fmt::format("a number from 0 to {}", count()),
                  fmt::format("{}", sparse.count));
    if (!isIndexType(sparse.indices.componentType))
        file.fail(place + ".indices.componentType", "5121, 5123 or 5125",
                  fmt::format("{}", sparse.indices.componentType));
    for (const int offset : {sparse.indices.byteOffset, sparse.values.byteOffset})
        if (offset < 0) file.fail(place + ".byteOffset", "a number >= 0", fmt::format("{}", offset));
    const auto entries = static_cast<std::size_t>(sparse.count);
    _sparseIndexType = sparse.indices.componentType;
    _sparseIndices = elementRange(file, place + ".indices", sparse.indices.bufferView,
                                  static_cast<std::size_t>(sparse.indices.byteOffset), entries,
                                  componentSize(_sparseIndexType), 0);
    _sparseValues =
        elementRange(file, place + ".values", sparse.values.bufferView,
                     static_cast<std::size_t>(sparse.values.byteOffset), entries, _elementSize, 0);
    for (std::size_t k = 0; k < entries; ++k) {
        const std::uint32_t index = sparseIndex(k);
        if (index >= count())
            file.fail(fmt::format("{}.indices[{}]", place, k), fmt::format("an index below {}", count()),
                      fmt::format("{}", index));
        // The order is the format's rule, and what lets `element` search.
        if (k > 0 && index <= sparseIndex(k - 1))
            file.fail(fmt::format("{}.indices[{}]", place, k),
                      fmt::format("an index above {}", sparseIndex(k - 1)), fmt::format("{}", index));
    }
}

std::uint32_t AccessorView::sparseIndex(std::size_t k) const {
    return loadIndex(_sparseIndices.first + k * _sparseIndices.stride, _sparseIndexType);
}

const std::uint8_t* AccessorView::element(std::size_t i) const {
    std::size_t low = 0, high = _sparseIndices.count;
    while (low < high) {
        const std::size_t middle = (low + high) / 2;
        if (sparseIndex(middle) < i)
            low = middle + 1;
        else
            high = middle;
    }
    if (low < _sparseIndices.count && sparseIndex(low) == i)
        return _sparseValues.first + low * _sparseValues.stride;
    return _elements.first ? _elements.first + i * _elements.stride : nullptr;
}

double AccessorView::component(std::size_t i, int c) const {
    const std::uint8_t* bytes = element(i);
    if (!bytes) return 0;
    bytes += static_cast<std::size_t>(c) * _componentSize;
    // glTF 2.0, 3.6.2.2: the most negative integer stands for −1 as well.
    const auto scaled = [&](auto value, double largest) {
        return _normalized ? std::max(static_cast<double>(value) / largest, -1.0)
                           : static_cast<double>(value);
    };
    switch (_componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
        return scaled(load<std::int8_t>(bytes), 127);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return scaled(load<std::uint8_t>(bytes), 255);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
        return scaled(load<std::int16_t>(bytes), 32767);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return scaled(load<std::uint16_t>(bytes), 65535);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return load<std::uint32_t>(bytes);
    default:
        return static_cast<double>(load<float>(bytes));
    }
}

std::uint32_t AccessorView::index(std::size_t i) const {
    const std::uint8_t* bytes = element(i);
    return bytes ? loadIndex(bytes, _componentType) : 0;
}

} // namespace limpid::io
