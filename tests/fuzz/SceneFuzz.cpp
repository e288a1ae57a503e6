// Any bytes as a scene file; behind a zero byte, lines of KEY=VALUE as --set has them. They load as a scene that
// can be written and loaded again, or are an InputError of one line.
#include <cmath>
#include <cstring>

#include "FuzzFile.h"
#include "Require.h"
#include "core/Error.h"
#include "io/toml/SceneDocument.h"
#include "scene/Mesh.h"

namespace limpid {
namespace {

/// Enough for each to meet what the ones before left; more would test the same again, slowly.
constexpr std::size_t maxOverrides = 4;

std::vector<io::Override> overridesOf(std::string_view lines) {
    std::vector<io::Override> overrides;
    while (!lines.empty() && overrides.size() < maxOverrides) {
        const std::string_view line = lines.substr(0, lines.find('\n'));
        lines.remove_prefix(std::min(lines.size(), line.size() + 1));
        const std::size_t equals = line.find('=');
        if (equals == 0 || equals == line.npos) continue;
        overrides.push_back({std::string(line.substr(0, equals)), std::string(line.substr(equals + 1))});
    }
    return overrides;
}

void checkScene(const Scene& scene) {
    fuzz::require(std::isfinite(scene.water.level) && scene.water.grid.x > 0 && scene.water.grid.y > 0);
    for (const Receiver& receiver : scene.receivers) {
        fuzz::require(receiver.mesh && !receiver.mesh->indices.empty());
        fuzz::require(std::abs(glm::length(receiver.rotation) - 1) < 1e-9);
    }
}

/// As the viewer does it.
void saveChanged(const io::SceneDocument& document, const std::filesystem::path& folder) {
    Scene changed = document.scene();
    changed.water.level += 0.125;
    changed.caustics.planes = 7;
    try {
        document.textOf(changed, folder);
    } catch (const InputError& error) {
        fuzz::requireOneLine(error.what());
    }
}

} // namespace
} // namespace limpid

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace limpid;
    static fuzz::FuzzFile file("scene.toml");
    const void* zero = size ? std::memchr(data, 0, size) : nullptr;
    const std::size_t length = zero ? std::size_t(static_cast<const std::uint8_t*>(zero) - data) : size;
    const std::string_view rest(reinterpret_cast<const char*>(data) + length, size - length);
    try {
        const auto& path = file.write(data, length);
        const io::SceneDocument document(path, overridesOf(rest.substr(std::min<std::size_t>(1, rest.size()))));
        checkScene(document.scene());
        saveChanged(document, path.parent_path());
    } catch (const InputError& error) {
        fuzz::requireOneLine(error.what());
    }
    return 0;
}
