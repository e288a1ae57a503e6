#pragma once
#include <filesystem>

/// Names of outputs mean here what they mean to other tools.
namespace limpid::io {

/// The end of the way that an output's name is: a file, there or not, or an open file of this program.
struct Output {
    std::filesystem::path file; ///< no link
    int descriptor = -1;        ///< of /dev/stdout, /dev/fd/N and the like; -1: it is to be opened by name

    /// True for pipes, character devices and open files: they take bytes as they come, and nothing is
    /// replaced.
    bool isStream() const;
};

/// Follows symbolic links, also one to a file that is not there yet. Throws InputError for links in a circle.
Output outputOf(const std::filesystem::path& name);

/// Throws InputError if nothing can be written under that name: its folder is missing or closed to writing,
/// or it is itself a folder, a block device, or a file closed to writing.
void requireOutput(const std::filesystem::path& name);

/// Puts `partial` in the place of a regular file, whose mode it takes over, or where none is. Throws
/// std::filesystem::filesystem_error.
void replaceFile(const std::filesystem::path& partial, const std::filesystem::path& file);

/// Sends the bytes of a file to a stream. Throws std::system_error.
void sendFile(const std::filesystem::path& file, const Output& stream);

} // namespace limpid::io
