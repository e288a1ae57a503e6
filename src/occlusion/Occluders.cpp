#include "occlusion/Occluders.h"

#include <cstddef>
#include <cstring>
#include <vector>

#include "core/Bvh.h"
#include "core/ShaderData.h"
#include "gl/Bindings.h"
#include "levelmap/HostTriangles.h"

namespace limpid {

namespace {

using Triangle = gpu::OccluderTriangle;
using gpu::VeilTriangle;

Box3f boxOf(const Triangle& triangle) {
    Box3f box;
    for (const glm::vec3& p : {triangle.a, triangle.b, triangle.c})
        box.add(p);
    return box;
}

struct VeilImage {
    std::int32_t firstTexel = -1; ///< < 0: no image
    std::int32_t width = 0, height = 0;
    std::int32_t flags = 0; ///< Wrap of u and, times 4, of v; 16: nearest texel; 32: sRGB
};
struct VeilMaterial {
    float cutoff;       ///< alpha below it is a hole; < 0: none
    float transmission; ///< [0, 1]
    std::int32_t blended;
    std::int32_t spare = 0;
    VeilImage baseColor{}, transmissionImage{};
};
static_assert(sizeof(VeilMaterial) == 4 * gpu::veilMaterialWords &&
              offsetof(VeilMaterial, baseColor) == 4 * gpu::baseImage &&
              offsetof(VeilMaterial, transmissionImage) == 4 * gpu::transmissionImage);

/// Whether light may pass some part of what is made of it.
bool isVeil(const Material& material) {
    return material.alphaMode != AlphaMode::Opaque || material.transmission > 0;
}

/// Everything that is uploaded.
struct Collected {
    std::vector<Triangle> triangles;
    std::vector<VeilTriangle> veils;
    std::vector<VeilMaterial> materials;
    std::vector<std::uint32_t> texels; ///< RGBA8, as in Image
    bool coloured = false;
};

VeilImage addImage(Collected& all, const Mesh& mesh, int index, Wrap s, Wrap t, bool nearest) {
    if (index < 0) return {};
    const Image& image = mesh.images[std::size_t(index)];
    if (image.width <= 0 || image.height <= 0) return {};
    const std::size_t first = all.texels.size();
    all.texels.resize(first + std::size_t(image.width) * std::size_t(image.height));
    std::memcpy(all.texels.data() + first, image.rgba.data(), image.rgba.size());
    return {int(first), image.width, image.height,
            int(s) + 4 * int(t) + (nearest ? 16 : 0) + (image.srgb ? 32 : 0)};
}

/// Index of the material of a part; -1: opaque.
int addMaterial(Collected& all, const Mesh& mesh, const Material& material) {
    if (!isVeil(material)) return -1;
    all.coloured = all.coloured || material.transmission > 0;
    all.materials.push_back({material.alphaMode == AlphaMode::Mask ? material.alphaCutoff : -1.0f,
                             material.transmission, material.alphaMode == AlphaMode::Blend ? 1 : 0, 0,
                             addImage(all, mesh, material.baseColorImage, material.baseColorWrapS,
                                      material.baseColorWrapT, material.baseColorNearest),
                             addImage(all, mesh, material.transmissionImage, material.transmissionWrapS,
                                      material.transmissionWrapT, false)});
    return int(all.materials.size()) - 1;
}

int addVeil(Collected& all, const Mesh& mesh, std::uint32_t firstIndex, int part, int veilMaterial) {
    if (veilMaterial < 0) return -1;
    VeilTriangle veil{{}, {}, veilMaterial, 0};
    for (std::uint32_t c = 0; c < 3; ++c) {
        const std::uint32_t corner = mesh.indices[firstIndex + c];
        const glm::vec4 own =
            mesh.colors.empty() ? glm::vec4(1) : glm::clamp(mesh.colors[corner], 0.0f, 1.0f);
        veil.colors[c] = own * mesh.materials[std::size_t(mesh.parts[std::size_t(part)].material)].baseColor;
        veil.uvs[c] = mesh.uvs[corner];
    }
    all.veils.push_back(veil);
    return int(all.veils.size()) - 1;
}

void add(Collected& all, const Receiver& receiver, const Mesh& mesh, int number, const glm::dvec3& origin) {
    std::vector<glm::vec3> places(mesh.positions.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        places[i] = glm::vec3(receiver.toWorld(mesh.positions[i]) - origin);
    for (int p = 0; p < int(mesh.parts.size()); ++p) {
        const MeshPart& part = mesh.parts[std::size_t(p)];
        const int material = addMaterial(all, mesh, mesh.materials[std::size_t(part.material)]);
        for (std::uint32_t i = part.firstIndex; i + 2 < part.firstIndex + part.indexCount; i += 3)
            all.triangles.push_back({places[mesh.indices[i]], number, places[mesh.indices[i + 1]],
                                     addVeil(all, mesh, i, p, material), places[mesh.indices[i + 2]], 0});
    }
}

/// Materials, then texels, in one block of words.
std::vector<std::uint32_t> materialWords(Collected& all) {
    const std::size_t words = all.materials.size() * sizeof(VeilMaterial) / 4;
    for (VeilMaterial& material : all.materials)
        for (VeilImage* image : {&material.baseColor, &material.transmissionImage})
            if (image->firstTexel >= 0) image->firstTexel += int(words);
    std::vector<std::uint32_t> out(words);
    std::memcpy(out.data(), all.materials.data(), 4 * words);
    out.insert(out.end(), all.texels.begin(), all.texels.end());
    return out;
}

} // namespace

Occluders::Occluders(gl::Context& context, std::span<const Receiver> receivers, const glm::dvec3& origin) {
    Collected all;
    for (std::size_t i = 0; i < receivers.size(); ++i)
        if (const Receiver& receiver = receivers[i]; receiver.host)
            add(all, receiver, readTriangles(*receiver.host), int(i), origin);
        else
            add(all, receiver, *receiver.mesh, int(i), origin);
    std::vector<Box3f> boxes;
    for (const Triangle& triangle : all.triangles)
        boxes.push_back(boxOf(triangle));
    const Bvh bvh = buildBvh(boxes);
    std::vector<Triangle> sorted;
    for (const std::uint32_t i : bvh.order)
        sorted.push_back(all.triangles[i]);
    gl::Ledger& ledger = context.ledger();
    _nodes = gl::Buffer(ledger, "occluders", std::span<const BvhNode>(bvh.nodes));
    _triangles = gl::Buffer(ledger, "occluders", std::span<const Triangle>(sorted));
    _veiled = !all.veils.empty();
    _coloured = all.coloured;
    if (!_veiled) return;
    _veils = gl::Buffer(ledger, "occluders", std::span<const VeilTriangle>(all.veils));
    _materials = gl::Buffer(ledger, "occluders", std::span<const std::uint32_t>(materialWords(all)));
}

void Occluders::bind() const {
    _nodes.bindStorage(occluderNodesBuffer);
    _triangles.bindStorage(occluderTrianglesBuffer);
    if (!_veiled) return;
    _veils.bindStorage(veilTrianglesBuffer);
    _materials.bindStorage(veilMaterialsBuffer);
}

} // namespace limpid
