#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "apps/viewer/Display.h"
#include "apps/viewer/State.h"
#include "io/toml/SceneDocument.h"

/// What the viewer writes: scenes, pictures and sequences of them. Pictures and sequences are numbered, so
/// that none takes another's place. All throw InputError when they cannot.
namespace limpid::viewer {

/// The name that saving proposes: the scene's own file, or a new one in the current folder for a model.
std::string proposedScene(const std::filesystem::path& file);

void saveScene(const io::SceneDocument& document, const Scene& scene, const std::filesystem::path& file);

/// Writes the picture to NAME-1.png or the first number that is free, in the current folder; gives its name.
std::filesystem::path savePicture(const Display& display, const std::filesystem::path& scene);

/// A sequence of complete pictures at equal steps of time.
class Recorder {
  public:
    static constexpr double framesPerSecond = 30;

    /// Makes a folder for it.
    Recorder(const std::filesystem::path& scene, double time);
    /// Of the picture that is to be added next, s.
    double time() const { return _begin + _count / framesPerSecond; }
    void add(const Display& display);
    /// What there is to say at its end.
    std::string summary() const;

  private:
    std::filesystem::path _folder;
    double _begin;
    int _count = 0;
};

} // namespace limpid::viewer
