#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/Error.h"
#include "limpid/SceneChecks.h"

namespace limpid {

namespace {

void requireLength(const std::string& place, std::size_t length, std::size_t expected, bool mayBeEmpty) {
    if (length != expected && !(mayBeEmpty && length == 0))
        failCheck(place, fmt::format("{} of them, one a position{}", expected, mayBeEmpty ? ", or none" : ""),
                  fmt::format("{}", length));
}

template <typename Vectors>
void requireFinite(const std::string& place, const Vectors& vectors) {
    for (std::size_t i = 0; i < vectors.size(); ++i)
        for (int c = 0; c < vectors[i].length(); ++c)
            if (!std::isfinite(vectors[i][c]))
                failCheck(fmt::format("{}[{}]", place, i), "finite numbers",
                          fmt::format("{}", vectors[i][c]));
}

void requireIndex(const std::string& place, std::int64_t index, std::int64_t least, std::size_t count) {
    if (index < least || index >= std::int64_t(count))
        failCheck(place, fmt::format("an index from {} to {}", least, std::int64_t(count) - 1),
                  fmt::format("{}", index));
}

void requireParts(const std::string& place, const Mesh& mesh) {
    for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
        const MeshPart& part = mesh.parts[i];
        const std::string of = fmt::format("{}.parts[{}]", place, i);
        if (part.indexCount % 3 != 0)
            failCheck(of + ".indexCount", "a multiple of 3", fmt::format("{}", part.indexCount));
        if (std::size_t(part.firstIndex) + part.indexCount > mesh.indices.size())
            failCheck(of, fmt::format("an end of at most {}", mesh.indices.size()),
                      fmt::format("{}", std::size_t(part.firstIndex) + part.indexCount));
        requireIndex(of + ".material", part.material, 0, mesh.materials.size());
    }
}

void requireImages(const std::string& place, const Mesh& mesh) {
    for (std::size_t i = 0; i < mesh.materials.size(); ++i) {
        const Material& material = mesh.materials[i];
        for (const int image : {material.baseColorImage, material.normalImage, material.transmissionImage,
                                material.emissionImage})
            requireIndex(fmt::format("{}.materials[{}] image", place, i), image, -1, mesh.images.size());
    }
    for (std::size_t i = 0; i < mesh.images.size(); ++i) {
        const Image& image = mesh.images[i];
        const std::size_t bytes =
            4 * std::size_t(std::max(image.width, 0)) * std::size_t(std::max(image.height, 0));
        if (image.rgba.size() != bytes)
            failCheck(fmt::format("{}.images[{}].rgba", place, i),
                      fmt::format("{} bytes of {} x {} texels", bytes, image.width, image.height),
                      fmt::format("{}", image.rgba.size()));
    }
}

} // namespace

void requireMesh(const Mesh& mesh, const std::string& place) {
    const std::size_t count = mesh.positions.size();
    requireLength(place + ".normals", mesh.normals.size(), count, false);
    requireLength(place + ".uvs", mesh.uvs.size(), count, false);
    requireLength(place + ".normalUvs", mesh.normalUvs.size(), count, true);
    requireLength(place + ".colors", mesh.colors.size(), count, true);
    requireFinite(place + ".positions", mesh.positions);
    requireFinite(place + ".normals", mesh.normals);
    if (mesh.indices.empty() || mesh.indices.size() % 3 != 0)
        failCheck(place + ".indices", "a multiple of 3, at least 3", fmt::format("{}", mesh.indices.size()));
    // A mesh may have millions: words are made for a wrong one only.
    const auto wrong = std::find_if(mesh.indices.begin(), mesh.indices.end(),
                                    [&](std::uint32_t index) { return index >= count; });
    if (wrong != mesh.indices.end())
        requireIndex(fmt::format("{}.indices[{}]", place, wrong - mesh.indices.begin()), *wrong, 0, count);
    if (mesh.parts.empty()) failCheck(place + ".parts", "at least one", "none");
    requireParts(place, mesh);
    requireImages(place, mesh);
}

} // namespace limpid
