#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/Staging.h"

/// Whole files in and out, with errors that fit on one line.
namespace limpid::io {

/// `text` fit for a terminal: what is not UTF-8, and control characters, as \x1b and the like; line breaks
/// become spaces.
std::string legible(std::string_view text);

/// `text` fit for one line of an error: line breaks and other control characters become spaces, what is not
/// UTF-8 is spelt out, at most `limit` bytes.
std::string oneLine(std::string_view text, std::size_t limit = 200);

/// The suffix of a file's name, dot included, its ASCII letters in lower case: names come in capitals, too.
std::string lowerCaseSuffix(const std::filesystem::path& file);

/// " (#### is written %04d)" for a name with a run of #, as other programs number frames; else empty.
std::string hashHint(std::string_view name);

/// Throws InputError unless `file` is a regular file that is not empty.
void requireFile(const std::filesystem::path& file);

/// The bytes of a file. Throws InputError if there is no such file, or if it is empty or a folder.
std::vector<std::uint8_t> readBytes(const std::filesystem::path& file);

/// Lets `write` fill a file of the same name in a hidden folder beside `file` and moves it to `file`, so that
/// `file` appears whole or not at all; links are followed, and an old file's mode stays. To a pipe or device
/// goes what is whole. Throws InputError if anything fails; `write` reports failure by a std::exception.
void writeWhole(const std::filesystem::path& file,
                const std::function<void(const std::filesystem::path& partial)>& write);

/// Files that belong together in a folder: they are written in a hidden one inside of it, and what stands in
/// the folder stays as it is until all are there.
class StagedFolder {
  public:
    /// `folder` exists. Throws InputError if it cannot be written to.
    explicit StagedFolder(std::filesystem::path folder);

    /// Where to write them. What has not appeared is gone with the object.
    const std::filesystem::path& path() const { return _staging->path(); }

    /// Puts the files in their place. `index`, which tells of the others, is gone before the first of them
    /// and comes last. Throws InputError.
    void appear(const std::string& index);

  private:
    std::filesystem::path _folder;
    std::optional<Staging> _staging;
};

void writeText(const std::filesystem::path& file, const std::string& text);

} // namespace limpid::io
