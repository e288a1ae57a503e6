#include "io/Outputs.h"

#include <cerrno>
#include <charconv>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "core/Error.h"
#include "io/Files.h"

namespace fs = std::filesystem;

namespace limpid::io {

namespace {

constexpr int mostLinks = 40; // as Linux has it

fs::path folderOf(const fs::path& file) {
    return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

/// The number of an open file that a name in /dev/fd or /proc/self/fd stands for. Opened by that name, a
/// regular file would lose what is in it.
std::optional<int> descriptorOf(const fs::path& file) {
    std::error_code error;
    if (fs::canonical(folderOf(file), error) != fs::canonical("/proc/self/fd", error) || error) return {};
    const std::string name = file.filename().string();
    int number = -1;
    const auto [end, wrong] = std::from_chars(name.data(), name.data() + name.size(), number);
    if (wrong != std::errc() || end != name.data() + name.size()) return {};
    return number;
}

/// Expected and found where nothing can be written; empty where it can.
std::string objection(const Output& output) {
    std::error_code error;
    if (output.descriptor >= 0) return "";
    const fs::file_status status = fs::status(output.file, error);
    if (fs::is_directory(status)) return "a file to write to, found a folder";
    if (fs::is_block_file(status)) return "a file to write to, found a block device";
    if (fs::exists(status) && ::access(output.file.c_str(), W_OK) != 0)
        return "a file to write to, found one closed to writing";
    if (output.isStream()) return "";
    const fs::path folder = folderOf(output.file);
    const std::string name = oneLine(folder.string());
    if (!fs::is_directory(folder, error)) return "a folder to write to, found none named " + name;
    return ::access(folder.c_str(), W_OK) == 0
               ? ""
               : fmt::format("a folder to write to, found {} closed to writing", name);
}

} // namespace

bool Output::isStream() const {
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    return descriptor >= 0 || fs::is_fifo(status) || fs::is_character_file(status) || fs::is_socket(status);
}

Output outputOf(const fs::path& name) {
    fs::path file = name;
    std::error_code error;
    for (int i = 0; i < mostLinks; ++i) {
        if (const auto descriptor = descriptorOf(file)) return {file, *descriptor};
        if (!fs::is_symlink(file, error)) return {file};
        file = file.parent_path() / fs::read_symlink(file, error); // an absolute one stands for itself
    }
    throw InputError(fmt::format("{}: cannot write: it is a link in a circle", oneLine(name.string())));
}

void requireOutput(const fs::path& name) {
    if (const std::string text = objection(outputOf(name)); !text.empty())
        throw InputError(fmt::format("{}: expected {}", oneLine(name.string()), text));
}

void replaceFile(const fs::path& partial, const fs::path& file) {
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (fs::is_regular_file(status)) fs::permissions(partial, status.permissions());
    fs::rename(partial, file);
}

void sendFile(const fs::path& file, const Output& stream) {
    const std::vector<std::uint8_t> bytes = readBytes(file);
    const int opened = stream.descriptor >= 0 ? ::dup(stream.descriptor)
                                              : ::open(stream.file.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
    if (opened < 0) throw std::system_error(errno, std::generic_category());
    std::size_t sent = 0;
    while (sent < bytes.size()) {
        const ssize_t count = ::write(opened, bytes.data() + sent, bytes.size() - sent);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) break;
        sent += std::size_t(count);
    }
    const int failure = sent < bytes.size() ? errno : 0;
    ::close(opened);
    if (failure != 0) throw std::system_error(failure, std::generic_category());
}

} // namespace limpid::io
