#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "io/toml/SceneFile.h"
#include "scene/Scene.h"

namespace limpid::io {

/// A scene's file, so that the scene can be written again after it was changed: as it was, comments included,
/// but for what changed.
class SceneDocument {
  public:
    /// As loadScene (io/toml/SceneFile.h).
    explicit SceneDocument(const std::filesystem::path& file, const std::vector<Override>& overrides = {});
    ~SceneDocument();
    SceneDocument(SceneDocument&&) noexcept;
    SceneDocument& operator=(SceneDocument&&) noexcept;

    /// As the file and the overrides say.
    const Scene& scene() const;

    /// The text of a scene file in `folder` that loads as `changed`: this document's scene with other
    /// numbers, other waves or another method; lights and receivers stay the same in number, name and shape.
    /// Comments are lost where the file cannot be changed in place.
    std::string textOf(const Scene& changed, const std::filesystem::path& folder) const;

  private:
    struct Content;
    std::unique_ptr<Content> _content;
};

} // namespace limpid::io
