#include "reference/Cutouts.h"

#include <algorithm>
#include <cmath>

namespace limpid::reference {

namespace {

float cutoff(const Material& material) {
    if (material.alphaMode == AlphaMode::Opaque) return 0;
    return material.alphaMode == AlphaMode::Mask ? material.alphaCutoff : 0.5f;
}

int wrapped(int i, int count, Wrap wrap) {
    if (wrap == Wrap::Clamp) return std::clamp(i, 0, count - 1);
    const int period = wrap == Wrap::Mirror ? 2 * count : count;
    const int in = (i % period + period) % period;
    return in < count ? in : period - 1 - in;
}

float texelAlpha(const Image& image, const Material& material, int x, int y) {
    const auto column = std::size_t(wrapped(x, image.width, material.baseColorWrapS));
    const auto row = std::size_t(wrapped(y, image.height, material.baseColorWrapT));
    return float(image.rgba[4 * (row * std::size_t(image.width) + column) + 3]) / 255.0f;
}

float imageAlpha(const Image& image, const Material& material, const glm::vec2& uv) {
    if (image.width <= 0 || image.height <= 0) return 1;
    // Beyond a billion texels a float has no place left between two of them.
    const glm::vec2 at = glm::clamp(uv * glm::vec2(image.width, image.height), -1e9f, 1e9f);
    if (material.baseColorNearest)
        return texelAlpha(image, material, int(std::floor(at.x)), int(std::floor(at.y)));
    const glm::vec2 low = glm::floor(at - 0.5f), part = at - 0.5f - low;
    const int x = int(low.x), y = int(low.y);
    return glm::mix(
        glm::mix(texelAlpha(image, material, x, y), texelAlpha(image, material, x + 1, y), part.x),
        glm::mix(texelAlpha(image, material, x, y + 1), texelAlpha(image, material, x + 1, y + 1), part.x),
        part.y);
}

} // namespace

Cutouts::Cutouts(const Mesh& mesh) {
    const bool some = std::any_of(mesh.materials.begin(), mesh.materials.end(),
                                  [](const Material& material) { return cutoff(material) > 0; });
    if (!some) return;
    _materials.assign(mesh.triangleCount(), 0);
    for (const MeshPart& part : mesh.parts)
        std::fill_n(_materials.begin() + part.firstIndex / 3, part.indexCount / 3, part.material);
}

bool Cutouts::at(const Mesh& mesh, std::uint32_t face, const glm::vec2& place) const {
    const Material& material = mesh.materials[std::size_t(_materials[face])];
    if (cutoff(material) <= 0) return false;
    const glm::vec3 weights(1 - place.x - place.y, place);
    glm::vec2 uv(0);
    float color = 0;
    for (int c = 0; c < 3; ++c) {
        const std::uint32_t corner = mesh.indices[3 * face + std::uint32_t(c)];
        uv += weights[c] * mesh.uvs[corner];
        color += weights[c] * (mesh.colors.empty() ? 1.0f : glm::clamp(mesh.colors[corner].a, 0.0f, 1.0f));
    }
    const float image = material.baseColorImage < 0
                            ? 1.0f
                            : imageAlpha(mesh.images[std::size_t(material.baseColorImage)], material, uv);
    return material.baseColor.a * color * image < cutoff(material);
}

} // namespace limpid::reference
