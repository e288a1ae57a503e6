#include "io/Files.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>

#include "core/Error.h"
#include "io/Outputs.h"

namespace fs = std::filesystem;

namespace limpid::io {

namespace {

/// Bytes of the character that `text` begins with; 0 where it is none of UTF-8.
std::size_t characterBytes(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const std::size_t count = byte(0) < 0x80   ? 1
                              : byte(0) < 0xC2 ? 0
                              : byte(0) < 0xE0 ? 2
                              : byte(0) < 0xF0 ? 3
                              : byte(0) < 0xF5 ? 4
                                               : 0;
    if (count > text.size()) return 0;
    for (std::size_t i = 1; i < count; ++i)
        if ((byte(i) & 0xC0) != 0x80) return 0;
    // Longer than need be, halves of pairs, and past the last plane.
    if (count == 3 && ((byte(0) == 0xE0 && byte(1) < 0xA0) || (byte(0) == 0xED && byte(1) > 0x9F))) return 0;
    if (count == 4 && ((byte(0) == 0xF0 && byte(1) < 0x90) || (byte(0) == 0xF4 && byte(1) > 0x8F))) return 0;
    return count;
}

} // namespace

std::string legible(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const std::size_t count = characterBytes(text);
        const auto first = static_cast<unsigned char>(text[0]);
        if (first == '\n')
            out += ' ';
        else if (count == 0 || (count == 1 && (first < ' ' || first == 0x7f)))
            out += fmt::format("\\x{:02x}", first);
        else
            out += text.substr(0, count);
        text.remove_prefix(std::max<std::size_t>(count, 1));
    }
    return out;
}

std::string oneLine(std::string_view bytes, std::size_t limit) {
    std::string text, line;
    for (const char c : bytes)
        text += static_cast<unsigned char>(c) <= ' ' || c == '\x7f' ? ' ' : c;
    for (const char c : legible(text)) {
        const bool blank = static_cast<unsigned char>(c) <= ' ' || c == '\x7f';
        if (!blank)
            line += c;
        else if (!line.empty() && line.back() != ' ')
            line += ' ';
    }
    while (!line.empty() && line.back() == ' ')
        line.pop_back();
    if (line.size() <= limit) return line;
    std::size_t end = limit;
    while (end > 0 && (static_cast<unsigned char>(line[end]) & 0xC0) == 0x80)
        --end; // not inside a character
    return line.substr(0, end) + "…";
}

std::string lowerCaseSuffix(const fs::path& file) {
    std::string suffix = file.extension().string();
    for (char& c : suffix)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return suffix;
}

std::string hashHint(std::string_view name) {
    const std::size_t first = name.find('#');
    if (first == std::string_view::npos) return "";
    const std::size_t end = std::min(name.find_first_not_of('#', first), name.size());
    return fmt::format(" ({} is written %{})", name.substr(first, end - first),
                       end - first == 1 ? "d" : fmt::format("0{}d", end - first));
}

void requireFile(const fs::path& file) {
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    const auto fail = [&](const std::string& found) {
        throw InputError(fmt::format("{}: expected a file, found {}", oneLine(file.string()), found));
    };
    if (status.type() == fs::file_type::not_found)
        fail("nothing of that name" + hashHint(file.filename().string()));
    if (error) fail(error.message());
    if (fs::is_directory(status)) fail("a folder");
    if (!fs::is_regular_file(status)) fail("something that is no regular file");
    if (fs::file_size(file, error) == 0) fail("an empty file");
}

std::vector<std::uint8_t> readBytes(const fs::path& file) {
    requireFile(file);
    std::ifstream stream(file, std::ios::binary);
    std::vector<std::uint8_t> bytes;
    if (stream) {
        bytes.resize(fs::file_size(file));
        stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    }
    if (!stream)
        throw InputError(fmt::format("{}: cannot read: {}", oneLine(file.string()), std::strerror(errno)));
    return bytes;
}

void writeWhole(const fs::path& file, const std::function<void(const fs::path&)>& write) {
    requireOutput(file);
    const Output output = outputOf(file);
    try {
        const Staging staging(output.isStream() ? fs::temp_directory_path() : output.file.parent_path());
        const fs::path partial = staging.path() / output.file.filename();
        write(partial);
        if (output.isStream())
            sendFile(partial, output);
        else
            Staging::whole([&] { replaceFile(partial, output.file); });
    } catch (const std::exception& error) {
        throw InputError(fmt::format("{}: cannot write: {}", oneLine(file.string()), oneLine(error.what())));
    }
}

namespace {

[[noreturn]] void failWriting(const fs::path& file, const std::string& reason) {
    throw InputError(fmt::format("{}: cannot write: {}", oneLine(file.string()), oneLine(reason)));
}

} // namespace

StagedFolder::StagedFolder(fs::path folder) : _folder(std::move(folder)) {
    try {
        _staging.emplace(_folder);
    } catch (const std::system_error& error) {
        failWriting(_folder, error.what());
    }
}

void StagedFolder::appear(const std::string& index) {
    std::vector<fs::path> names;
    for (const auto& entry : fs::directory_iterator(path()))
        if (entry.path().filename() != index) names.push_back(entry.path().filename());
    names.emplace_back(index);
    for (const fs::path& name : names)
        if (fs::is_directory(_folder / name)) failWriting(_folder / name, "it is a folder");
    Staging::whole([&] {
        std::error_code error;
        fs::remove(_folder / index, error);
        for (const fs::path& name : names) {
            if (!error) fs::rename(path() / name, _folder / name, error);
            if (error) failWriting(_folder / name, error.message());
        }
    });
}

void writeText(const fs::path& file, const std::string& text) {
    writeWhole(file, [&](const fs::path& partial) {
        std::ofstream stream(partial, std::ios::binary);
        stream << text;
        stream.close();
        if (!stream) throw std::runtime_error(std::strerror(errno));
    });
}

} // namespace limpid::io
