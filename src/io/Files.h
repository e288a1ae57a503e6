#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

/// Whole files in and out, with errors that fit on one line.
namespace limpid::io {

/// `text` fit for one line of an error: line breaks and other control characters become spaces, at most
/// `limit` bytes.
std::string oneLine(std::string_view text, std::size_t limit = 200);

/// Throws InputError unless `file` is a regular file that is not empty.
void requireFile(const std::filesystem::path& file);

/// The bytes of a file. Throws InputError if there is no such file, or if it is empty or a folder.
std::vector<std::uint8_t> readBytes(const std::filesystem::path& file);

/// Lets `write` fill a file beside `file` and renames it to `file`, so that `file` appears whole or not at
/// all. The partial file keeps the suffix, because image libraries choose the format by it. Throws InputError
/// if anything fails, after removing the partial file; `write` reports failure by a std::exception.
void writeWhole(const std::filesystem::path& file,
                const std::function<void(const std::filesystem::path& partial)>& write);

void writeText(const std::filesystem::path& file, const std::string& text);

} // namespace limpid::io
