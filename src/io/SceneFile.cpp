#include "io/SceneFile.h"

#include "io/SceneDocument.h"

namespace limpid::io {

Scene loadScene(const std::filesystem::path& file, const std::vector<Override>& overrides) {
    return SceneDocument(file, overrides).scene();
}

} // namespace limpid::io
