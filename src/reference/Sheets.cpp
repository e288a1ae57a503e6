#include "reference/Sheets.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/color_space.hpp>

namespace limpid::reference {

namespace {

/// How a texture is read.
struct Sampling {
    Wrap s, t;
    bool nearest;
};

int wrapped(int i, int count, Wrap wrap) {
    if (wrap == Wrap::Clamp) return std::clamp(i, 0, count - 1);
    const int period = wrap == Wrap::Mirror ? 2 * count : count;
    const int in = (i % period + period) % period;
    return in < count ? in : period - 1 - in;
}

/// Linear.
glm::vec4 texel(const Image& image, const Sampling& how, int x, int y) {
    const auto column = std::size_t(wrapped(x, image.width, how.s));
    const auto row = std::size_t(wrapped(y, image.height, how.t));
    const std::uint8_t* stored = &image.rgba[4 * (row * std::size_t(image.width) + column)];
    const glm::vec4 value = glm::vec4(stored[0], stored[1], stored[2], stored[3]) / 255.0f;
    return image.srgb ? glm::vec4(glm::convertSRGBToLinear(glm::vec3(value)), value.a) : value;
}

/// White without an image.
glm::vec4 sampled(const Mesh& mesh, int index, const Sampling& how, const glm::vec2& uv) {
    if (index < 0) return glm::vec4(1);
    const Image& image = mesh.images[std::size_t(index)];
    if (image.width <= 0 || image.height <= 0) return glm::vec4(1);
    // Beyond a billion texels a float has no place left between two of them.
    const glm::vec2 at = glm::clamp(uv * glm::vec2(image.width, image.height), -1e9f, 1e9f);
    if (how.nearest) return texel(image, how, int(std::floor(at.x)), int(std::floor(at.y)));
    const glm::vec2 low = glm::floor(at - 0.5f), part = at - 0.5f - low;
    const int x = int(low.x), y = int(low.y);
    return glm::mix(glm::mix(texel(image, how, x, y), texel(image, how, x + 1, y), part.x),
                    glm::mix(texel(image, how, x, y + 1), texel(image, how, x + 1, y + 1), part.x), part.y);
}

} // namespace

Sheets::Sheets(const Mesh& mesh) {
    if (std::none_of(mesh.materials.begin(), mesh.materials.end(), isTranslucent)) return;
    _partly = isPartlyBlended(mesh);
    _materials.assign(mesh.triangleCount(), 0);
    for (const MeshPart& part : mesh.parts)
        std::fill_n(_materials.begin() + part.firstIndex / 3, part.indexCount / 3, part.material);
}

Sheets::Place Sheets::at(const Mesh& mesh, std::uint32_t face, const glm::vec2& place) const {
    const Material& material = mesh.materials[std::size_t(_materials[face])];
    const glm::vec3 weights(1 - place.x - place.y, place);
    Place found{glm::vec2(0), glm::vec4(0)};
    for (int c = 0; c < 3; ++c) {
        const std::uint32_t corner = mesh.indices[3 * face + std::uint32_t(c)];
        found.uv += weights[c] * mesh.uvs[corner];
        found.color +=
            weights[c] * (mesh.colors.empty() ? glm::vec4(1) : glm::clamp(mesh.colors[corner], 0.0f, 1.0f));
    }
    const Sampling how{material.baseColorWrapS, material.baseColorWrapT, material.baseColorNearest};
    found.color *= material.baseColor * sampled(mesh, material.baseColorImage, how, found.uv);
    found.color = glm::clamp(found.color, 0.0f, 1.0f);
    return found;
}

bool Sheets::isShown(const Mesh& mesh, std::uint32_t face, const glm::vec2& place) const {
    if (none()) return true;
    const Material& material = mesh.materials[std::size_t(_materials[face])];
    const float least = shownAlpha(material, _partly);
    return least <= 0 || (least <= 1 && at(mesh, face, place).color.a >= least);
}

glm::vec3 Sheets::transmittance(const Mesh& mesh, std::uint32_t face, const glm::vec2& place) const {
    if (none()) return glm::vec3(0);
    const Material& material = mesh.materials[std::size_t(_materials[face])];
    if (!isTranslucent(material)) return glm::vec3(0);
    const Place found = at(mesh, face, place);
    const Sampling how{material.transmissionWrapS, material.transmissionWrapT, false};
    const float transmission =
        material.transmission > 0
            ? material.transmission * sampled(mesh, material.transmissionImage, how, found.uv).r
            : 0.0f;
    return limpid::transmittance(material, found.color, transmission);
}

} // namespace limpid::reference
