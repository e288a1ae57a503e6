#pragma once
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "io/gltf/File.h"
#include "scene/Mesh.h"

namespace limpid::io {

/// Width and height that a PNG or JPEG claims, none for what is neither.
std::optional<glm::ivec2> pictureSize(std::span<const std::uint8_t> encoded);

/// The images of a file that a mesh uses, each decoded once. Those that are missing, broken or too large (a
/// side of more than 16384 pixels, 256 million pixels in all) cost one notice.
class ImageSet {
  public:
    /// Decodes into the mesh's images, with notices of what cannot be had; both must outlive the set.
    ImageSet(const GltfFile& file, Mesh& mesh) : _file(file), _mesh(mesh) {}

    /// The place in the mesh's images of the file's image `index`, -1 if it cannot be had. An image that is
    /// used as colours and as data is there twice. Throws InputError for a buffer view that breaks the
    /// format.
    int add(int index, bool srgb);

  private:
    std::optional<Image> decode(int index);

    const GltfFile& _file;
    Mesh& _mesh;
    std::map<std::pair<int, bool>, int> _known;
    std::size_t _pixels = 0;
};

} // namespace limpid::io
