#pragma once
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>

#include <fmt/format.h>

#include "core/Error.h"
#include "io/Files.h"

/// Parts that both builds of Images.h share (LIMPID_IMAGES).
namespace limpid::io {

/// A text in a picture's header, under this name.
inline constexpr const char* fingerprintKey = "LimpidFingerprint";

/// Numbers that a file of so many bytes may hold. 1 GiB of floats is given to any, as a picture of one colour
/// takes a few bytes; beyond, what its compressed bytes can stand for (deflate makes 1032 of one), so that a
/// broken header gets no memory for its claims.
inline std::int64_t mostNumbers(std::int64_t bytes) {
    return std::max(std::int64_t(1) << 28, 1032 * bytes);
}

/// Throws InputError.
[[noreturn]] inline void failReading(const std::filesystem::path& file, const std::string& reason) {
    throw InputError(fmt::format("{}: cannot read: {}", oneLine(file.string()), oneLine(reason)));
}

} // namespace limpid::io
