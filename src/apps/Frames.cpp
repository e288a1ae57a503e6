#include "apps/Frames.h"

#include <algorithm>
#include <charconv>
#include <csignal>
#include <cstdlib>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "apps/Common.h"
#include "core/Error.h"
#include "io/Files.h"
#include "io/Outputs.h"
#include "io/images/Images.h"
#include "io/toml/SceneSettings.h"
#include "scene/Fingerprint.h"

namespace limpid::apps {

namespace {

bool parseNumber(std::string_view text, int& value) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() && value >= 0 && value <= 9999999;
}

} // namespace

FrameRange parseFrames(const std::string& text) {
    FrameRange range;
    const std::size_t dots = text.find("..");
    if (dots != std::string::npos && parseNumber(std::string_view(text).substr(0, dots), range.first) &&
        parseNumber(std::string_view(text).substr(dots + 2), range.last) && range.first <= range.last)
        return range;
    throw InputError(fmt::format("--frames: expected A..B with 0 <= A <= B <= 9999999, found \"{}\"", text));
}

std::filesystem::path frameName(const std::string& pattern, int number) {
    const std::size_t percent = pattern.find('%');
    std::size_t end = percent == std::string::npos ? percent : percent + 1;
    while (end < pattern.size() && pattern[end] >= '0' && pattern[end] <= '9')
        ++end;
    const bool one =
        end < pattern.size() && pattern[end] == 'd' && pattern.find('%', end) == std::string::npos;
    const std::string digits = one ? pattern.substr(percent + 1, end - percent - 1) : "";
    if (!one || digits.size() > 2 || (!digits.empty() && digits[0] != '0'))
        throw InputError(
            fmt::format("{}: expected one %04d for the frame's number, found {}", pattern,
                        percent == std::string::npos ? "none" + io::hashHint(pattern) : "another pattern"));
    const int width = digits.empty() ? 1 : std::atoi(digits.c_str());
    return fmt::format("{}{:0{}}{}", pattern.substr(0, percent), number, width, pattern.substr(end + 1));
}

bool isVideo(const std::filesystem::path& file) {
    const std::string suffix = io::lowerCaseSuffix(file);
    return suffix == ".mp4" || suffix == ".mkv" || suffix == ".webm";
}

std::string FrameSequence::fingerprint(int frame) const {
    Hash hash;
    hash(_scene, frame / _fps);
    return fmt::format("{:016x}", hash.value());
}

FrameSequence::FrameSequence(const Scene& scene, std::string pattern, glm::ivec2 size, double fps)
    : _pattern(std::move(pattern)), _size(size), _fps(fps) {
    Hash hash;
    hash(lightFingerprint(scene), looksFingerprint(scene));
    for (const io::Setting& setting : io::settingsOf(scene)) {
        const std::string line =
            fmt::format("{}.{}.{}={}\n", setting.section, setting.entry, setting.key, setting.value);
        hash.add(line.data(), line.size());
    }
    hash.add(LIMPID_VERSION, sizeof LIMPID_VERSION);
    _scene = hash.value();
}

bool FrameSequence::isThere(int frame, bool overwrite) const {
    const std::filesystem::path file = frameName(_pattern, frame);
    if (!std::filesystem::exists(file)) return false;
    const auto stamp = io::readStamp(file);
    const bool sized = stamp && glm::ivec2(stamp->width, stamp->height) == _size;
    if (sized && stamp->fingerprint == fingerprint(frame)) return true;
    if (overwrite) return false;
    const std::string found = !stamp || stamp->fingerprint.empty() ? "another picture"
                              : sized                              ? "one of another scene or time"
                                      : fmt::format("one of {} x {}", stamp->width, stamp->height);
    throw InputError(fmt::format("{}: expected this scene's frame of {} x {} pixels, or none, found {}; "
                                 "--overwrite replaces it",
                                 io::oneLine(file.string()), _size.x, _size.y, found));
}

VideoWriter::VideoWriter(const std::filesystem::path& name, glm::ivec2 size, double fps)
    : _file(io::outputOf(name).file), _frameBytes(std::size_t(size.x) * std::size_t(size.y) * 3) {
    if (!onPath("ffmpeg"))
        throw InputError(fmt::format("{}: expected ffmpeg to write a video with, found none on the path; "
                                     "a name with %04d and .png gives pictures",
                                     name.string()));
    if (io::outputOf(name).isStream())
        throw InputError(
            fmt::format("{}: expected a file to write a video to, found a pipe or device", name.string()));
    try {
        _staging.emplace(_file.parent_path());
    } catch (const std::system_error& error) {
        throw InputError(fmt::format("{}: cannot write: {}", name.string(), error.what()));
    }
    const std::string resolution = fmt::format("{}x{}", size.x, size.y), rate = fmt::format("{}", fps);
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw InputError(fmt::format("{}: cannot start ffmpeg", name.string()));
    _complaints = memfd_create("ffmpeg", MFD_CLOEXEC);
    std::signal(SIGPIPE, SIG_IGN); // ffmpeg's end is noticed by the write that fails
    _process = fork();
    if (_process == 0) {
        dup2(ends[0], STDIN_FILENO);
        if (_complaints >= 0) dup2(_complaints, STDERR_FILENO);
        // yuv420p, which players expect, needs even sizes.
        execlp("ffmpeg", "ffmpeg", "-y", "-loglevel", "error", "-f", "rawvideo", "-pix_fmt", "rgb24", "-s",
               resolution.c_str(), "-r", rate.c_str(), "-i", "-", "-vf", "crop=trunc(iw/2)*2:trunc(ih/2)*2",
               "-pix_fmt", "yuv420p", partial().c_str(), static_cast<char*>(nullptr));
        _exit(127);
    }
    close(ends[0]);
    _pipe = ends[1];
}

VideoWriter::~VideoWriter() {
    if (_complaints >= 0) close(_complaints);
    if (_pipe < 0) return;
    close(_pipe);
    waitpid(_process, nullptr, 0);
}

std::filesystem::path VideoWriter::partial() const {
    return _staging->path() / _file.filename();
}

void VideoWriter::add(const std::uint8_t* rgb) {
    for (std::size_t sent = 0; sent < _frameBytes;) {
        const ssize_t bytes = write(_pipe, rgb + sent, _frameBytes - sent);
        if (bytes <= 0)
            throw InputError(
                fmt::format("{}: cannot write: ffmpeg gave up: {}", _file.string(), complaint()));
        sent += std::size_t(bytes);
    }
}

void VideoWriter::finish() {
    close(_pipe);
    _pipe = -1;
    int status = 0;
    waitpid(_process, &status, 0);
    // On a full disk ffmpeg says so, and ends with status 0.
    if (status != 0 || !complaint().empty())
        throw InputError(fmt::format("{}: cannot write: ffmpeg ended with status {}: {}", _file.string(),
                                     WIFEXITED(status) ? WEXITSTATUS(status) : -1, complaint()));
    try {
        io::Staging::whole([&] { io::replaceFile(partial(), _file); });
    } catch (const std::exception& error) {
        throw InputError(fmt::format("{}: cannot write: {}", _file.string(), error.what()));
    }
}

/// What ffmpeg has said, on one line.
std::string VideoWriter::complaint() const {
    char text[1000];
    const ssize_t bytes = _complaints >= 0 ? pread(_complaints, text, sizeof text, 0) : 0;
    return io::oneLine(std::string_view(text, std::size_t(std::max<ssize_t>(bytes, 0))));
}

} // namespace limpid::apps
