#pragma once
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "scene/Scene.h"

namespace limpid {

/// Fowler, Noll and Vo's hash, 64 bits, variant 1a.
class Hash {
  public:
    void add(const void* data, std::size_t bytes) {
        const auto* byte = static_cast<const unsigned char*>(data);
        for (std::size_t i = 0; i < bytes; ++i)
            _value = (_value ^ byte[i]) * 0x100000001b3u;
    }
    /// Numbers and vectors of them: nothing that the compiler pads.
    template <typename... Plain>
    void operator()(const Plain&... values) {
        static_assert((std::is_trivially_copyable_v<Plain> && ...));
        (add(&values, sizeof(values)), ...);
    }
    template <typename Plain>
    void list(const std::vector<Plain>& values) {
        (*this)(values.size());
        add(values.data(), values.size() * sizeof(Plain));
    }
    std::uint64_t value() const { return _value; }

  private:
    std::uint64_t _value = 0xcbf29ce484222325u;
};

/// A number that changes with whatever light depends on: water, lights, shapes and cut-outs of the receivers;
/// not with colours, camera or settings of a method. The same on every machine of one byte order.
std::uint64_t lightFingerprint(const Scene& scene);

/// A number that changes with the looks of the receivers: normals, colours, materials and pictures.
std::uint64_t looksFingerprint(const Scene& scene);

} // namespace limpid
