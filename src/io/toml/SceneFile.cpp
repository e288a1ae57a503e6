#include "io/toml/SceneFile.h"

#include "io/toml/SceneDocument.h"

namespace limpid::io {

Scene loadScene(const std::filesystem::path& file, const std::vector<Override>& overrides) {
    return SceneDocument(file, overrides).scene();
}

} // namespace limpid::io
