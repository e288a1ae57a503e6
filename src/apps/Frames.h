#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include <glm/glm.hpp>

#include "io/Staging.h"
#include "scene/Scene.h"

namespace limpid::apps {

/// The frames of `--frames A..B`, both included.
struct FrameRange {
    int first = 0;
    int last = 0;

    int count() const { return last - first + 1; }
};

/// Throws InputError unless `text` is A..B with 0 <= A <= B <= 9,999,999.
FrameRange parseFrames(const std::string& text);

/// The name of frame `number`: its `%d` or `%04d` replaced. Throws InputError unless there is exactly one.
std::filesystem::path frameName(const std::string& pattern, int number);

/// Whether the name asks for a video (.mp4, .mkv, .webm) in place of pictures.
bool isVideo(const std::filesystem::path& file);

/// Pictures of one scene, in files that say which frame of it they are, so that an interrupted sequence goes
/// on.
class FrameSequence {
  public:
    /// Frame i is at i / fps seconds.
    FrameSequence(const Scene& scene, std::string pattern, glm::ivec2 size, double fps);

    std::filesystem::path file(int frame) const { return frameName(_pattern, frame); }
    /// A number that changes with all that the frame's picture depends on but its size, as text.
    std::string fingerprint(int frame) const;
    /// True if the frame's file has its picture already. Throws InputError if it has another one, unless
    /// `overwrite`.
    bool isThere(int frame, bool overwrite) const;

  private:
    std::string _pattern;
    glm::ivec2 _size;
    double _fps;
    std::uint64_t _scene = 0;
};

/// Pictures on their way into ffmpeg. The video appears whole or not at all.
class VideoWriter {
  public:
    /// Throws InputError if ffmpeg is not there.
    VideoWriter(const std::filesystem::path& file, glm::ivec2 size, double fps);
    ~VideoWriter();
    VideoWriter(const VideoWriter&) = delete;
    VideoWriter& operator=(const VideoWriter&) = delete;

    /// `rgb`: 8-bit sRGB, width · height · 3 bytes. Throws InputError if ffmpeg has given up.
    void add(const std::uint8_t* rgb);
    /// Waits for ffmpeg and gives the video its name. Throws InputError if it failed.
    void finish();

  private:
    std::filesystem::path partial() const; ///< what ffmpeg writes
    std::string complaint() const;
    std::filesystem::path _file;
    std::optional<io::Staging> _staging;
    std::size_t _frameBytes;
    int _pipe = -1;
    int _complaints = -1; ///< a file in memory, which ffmpeg writes its errors to
    int _process = -1;
};

} // namespace limpid::apps
