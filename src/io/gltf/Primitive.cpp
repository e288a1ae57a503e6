#include "io/gltf/Primitive.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>

#include <fmt/format.h>

#include "io/gltf/Attributes.h"
#include "io/gltf/Materials.h"
#include "io/gltf/Triangles.h"

namespace limpid::io {

namespace {

/// Of the whole mesh: a small file can show one mesh at many nodes. 45 million triangles, some 6 GiB at most.
constexpr std::size_t maxCorners = std::size_t(1) << 27;

/// m; far beyond any scene, and squares of such lengths stay finite in single precision.
constexpr double maxCoordinate = 1e9;

/// What a primitive's vertices have, checked and made once for all of its copies.
struct Attributes {
    MorphedAttribute positions;
    std::optional<MorphedAttribute> normals;
    TextureMappings mappings;
    std::optional<MorphedAttribute> uvs, normalUvs; ///< of base colour and normal map
    std::optional<MorphedAttribute> colors;
    std::optional<SkinnedVertices> skin;
};

/// One copy of a primitive on its way into the mesh.
struct Copy {
    const PrimitiveTask& task;
    const Attributes& attributes;
    const glm::dmat4& transform;
    Mesh& mesh;
    std::size_t firstVertex;               ///< in `mesh`
    std::size_t firstIndex;                ///< in `mesh`
    std::vector<std::uint32_t> vertices{}; ///< of the primitive, in the order of their copies in `mesh`

    glm::dmat4 matrix(std::uint32_t vertex) const {
        return attributes.skin ? attributes.skin->matrix(vertex) : transform;
    }
};

std::optional<MorphedAttribute> morphed(const PrimitiveTask& task, const std::string& name,
                                        std::optional<AccessorView> base,
                                        const AccessorKind& targetKind = vectorKind()) {
    if (!base) return std::nullopt;
    const std::size_t count = base->count();
    MorphedAttribute attribute(std::move(*base));
    const auto& targets = task.primitive.targets;
    for (std::size_t i = 0; i < targets.size() && i < task.morphWeights.size(); ++i) {
        if (task.morphWeights[i] == 0) continue;
        auto target = findAttribute(task.file, fmt::format("{}.targets[{}]", task.place, i), targets[i], name,
                                    targetKind, count);
        if (target) attribute.add(std::move(*target), task.morphWeights[i]);
    }
    return attribute;
}

std::optional<Attributes> readAttributes(const PrimitiveTask& task) {
    const auto find = [&](const std::string& name, const AccessorKind& kind, auto... count) {
        return findAttribute(task.file, task.place, task.primitive.attributes, name, kind, count...);
    };
    std::optional<MorphedAttribute> positions = morphed(task, "POSITION", find("POSITION", vectorKind()));
    if (!positions) return std::nullopt;
    const std::size_t count = positions->count();
    const TextureMappings mappings = textureMappings(task.file, task.primitive.material);
    const auto uvs = [&](const TextureMapping& mapping) {
        const std::string name = fmt::format("TEXCOORD_{}", mapping.texCoord);
        return morphed(task, name, find(name, uvKind(), count), uvKind());
    };
    Attributes attributes{
        .positions = std::move(*positions),
        .normals = morphed(task, "NORMAL", find("NORMAL", normalKind(), count)),
        .mappings = mappings,
        .uvs = uvs(mappings.color),
        .normalUvs = uvs(mappings.normal),
        .colors = morphed(task, "COLOR_0", find("COLOR_0", colorKind(), count), colorDifferenceKind()),
        .skin = {}};
    if (task.joints) attributes.skin.emplace(task.file, task.place, task.primitive, count, *task.joints);
    if (attributes.skin && attributes.skin->empty()) attributes.skin.reset();
    return attributes;
}

/// Gives every vertex that a corner uses a copy in the mesh: one for all corners, or one for each (flat).
void addIndices(Copy& copy, const std::vector<std::uint32_t>& corners) {
    const bool flat = !copy.attributes.normals;
    const auto first = static_cast<std::uint32_t>(copy.firstVertex);
    std::unordered_map<std::uint32_t, std::uint32_t> copies;
    for (const std::uint32_t corner : corners) {
        const auto next = static_cast<std::uint32_t>(copy.vertices.size());
        const std::uint32_t index = flat ? next : copies.try_emplace(corner, next).first->second;
        if (index == next) copy.vertices.push_back(corner);
        copy.mesh.indices.push_back(first + index);
    }
}

/// A mirror turns front into back. A skin may do so by some of its joints.
void turnMirrored(const Copy& copy, std::vector<std::uint32_t>& corners) {
    if (!copy.attributes.skin && glm::determinant(glm::dmat3(copy.transform)) >= 0) return;
    for (std::size_t i = 0; i < corners.size(); i += 3)
        if (!copy.attributes.skin || glm::determinant(glm::dmat3(copy.matrix(corners[i]))) < 0)
            std::swap(corners[i + 1], corners[i + 2]);
}

void addPositions(const Copy& copy) {
    for (const std::uint32_t vertex : copy.vertices) {
        const glm::dvec3 p(copy.matrix(vertex) * glm::dvec4(copy.attributes.positions.read(vertex), 1.0));
        // Written so that NaN fails.
        if (!(std::abs(p.x) <= maxCoordinate && std::abs(p.y) <= maxCoordinate &&
              std::abs(p.z) <= maxCoordinate))
            copy.task.file.fail(fmt::format("{}.attributes.POSITION[{}]", copy.task.place, vertex),
                                fmt::format("finite coordinates of at most {:g} m", maxCoordinate),
                                fmt::format("{:g}, {:g}, {:g}", p.x, p.y, p.z));
        copy.mesh.positions.push_back(p);
    }
}

glm::dvec3 faceNormal(const Mesh& mesh, std::size_t firstIndex) {
    const glm::dvec3& a = mesh.positions[mesh.indices[firstIndex]];
    const glm::dvec3& b = mesh.positions[mesh.indices[firstIndex + 1]];
    const glm::dvec3& c = mesh.positions[mesh.indices[firstIndex + 2]];
    return glm::cross(b - a, c - a);
}

/// Unit length, or none for a vector that has no direction.
std::optional<glm::vec3> unit(const glm::dvec3& v) {
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (!(largest > 0) || !std::isfinite(largest)) return std::nullopt;
    const glm::vec3 result(glm::normalize(v / largest)); // no overflow or underflow in the squares
    return std::isfinite(result.x + result.y + result.z) ? std::optional(result) : std::nullopt;
}

/// For the vertices marked in `missing`: from the faces around them, by area. A vertex of degenerate faces
/// only gets some direction.
void addFaceNormals(Copy& copy, const std::vector<bool>& missing) {
    Mesh& mesh = copy.mesh;
    std::vector<glm::dvec3> sums(copy.vertices.size(), glm::dvec3(0));
    for (std::size_t i = copy.firstIndex; i < mesh.indices.size(); i += 3)
        for (std::size_t c = 0; c < 3; ++c)
            sums[mesh.indices[i + c] - copy.firstVertex] += faceNormal(mesh, i);
    for (std::size_t v = 0; v < sums.size(); ++v)
        if (missing[v]) mesh.normals[copy.firstVertex + v] = unit(sums[v]).value_or(glm::vec3(0, 1, 0));
}

/// Transforms by the cofactors, which unlike the inverse exist for every matrix.
glm::dvec3 transformNormal(const glm::dmat4& matrix, const glm::dvec3& normal) {
    const glm::dmat3 m(matrix);
    const double sign = glm::determinant(m) < 0 ? -1.0 : 1.0;
    const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    return sign * (cofactors * normal);
}

void addNormals(Copy& copy) {
    std::vector<bool> missing(copy.vertices.size(), false);
    for (std::size_t v = 0; v < copy.vertices.size(); ++v) {
        const std::uint32_t vertex = copy.vertices[v];
        std::optional<glm::vec3> normal;
        if (copy.attributes.normals)
            normal = unit(transformNormal(copy.matrix(vertex), copy.attributes.normals->read(vertex)));
        missing[v] = !normal;
        copy.mesh.normals.push_back(normal.value_or(glm::vec3(0)));
    }
    if (std::find(missing.begin(), missing.end(), true) != missing.end()) addFaceNormals(copy, missing);
}

void addUvs(const Copy& copy, const std::optional<MorphedAttribute>& source, const TextureMapping& mapping,
            std::vector<glm::vec2>& uvs) {
    for (const std::uint32_t vertex : copy.vertices) {
        glm::vec2 uv(0);
        if (source)
            uv = glm::vec2(mapping.transform *
                           glm::dvec3(source->component(vertex, 0), source->component(vertex, 1), 1));
        uvs.push_back(std::isfinite(uv.x) && std::isfinite(uv.y) ? uv : glm::vec2(0));
    }
}

/// The mesh has uvs for normal maps from the first primitive on whose normal map lies elsewhere than its base
/// colour.
void addAllUvs(Copy& copy) {
    const Attributes& attributes = copy.attributes;
    std::vector<glm::vec2>& normalUvs = copy.mesh.normalUvs;
    addUvs(copy, attributes.uvs, attributes.mappings.color, copy.mesh.uvs);
    if (attributes.mappings.normal == attributes.mappings.color && normalUvs.empty()) return;
    if (normalUvs.empty())
        normalUvs.assign(copy.mesh.uvs.begin(),
                         copy.mesh.uvs.begin() + static_cast<std::ptrdiff_t>(copy.firstVertex));
    addUvs(copy, attributes.normalUvs, attributes.mappings.normal, normalUvs);
}

/// The mesh has colours from the first primitive on that has some; what came before is white.
void addColors(Copy& copy) {
    std::vector<glm::vec4>& colors = copy.mesh.colors;
    if (!copy.attributes.colors && colors.empty()) return;
    colors.resize(copy.firstVertex, glm::vec4(1));
    for (const std::uint32_t vertex : copy.vertices) {
        glm::vec4 color(1);
        for (int c = 0; copy.attributes.colors && c < copy.attributes.colors->components(); ++c) {
            const double value = copy.attributes.colors->component(vertex, c);
            // The range is glTF's rule; NaN counts as no colour.
            color[c] = std::isnan(value) ? 1.0f : static_cast<float>(std::clamp(value, 0.0, 1.0));
        }
        colors.push_back(color);
    }
}

void addPart(Mesh& mesh, std::size_t firstIndex, int material) {
    const auto count = static_cast<std::uint32_t>(mesh.indices.size() - firstIndex);
    if (!mesh.parts.empty() && mesh.parts.back().material == material)
        mesh.parts.back().indexCount += count;
    else
        mesh.parts.push_back({static_cast<std::uint32_t>(firstIndex), count, material});
}

} // namespace

void addPrimitive(const PrimitiveTask& task, Mesh& mesh) {
    static const std::vector<glm::dmat4> inPlace = {glm::dmat4(1.0)};
    const std::optional<Attributes> attributes = readAttributes(task);
    const std::vector<glm::dmat4>& transforms = attributes && attributes->skin ? inPlace : task.transforms;
    if (!attributes || transforms.empty()) return;
    const std::vector<std::uint32_t> corners =
        triangleCorners(task.file, task.place, task.primitive, attributes->positions.count(),
                        (maxCorners - mesh.indices.size()) / transforms.size());
    if (corners.empty()) return;
    const int material = materialIndex(task.file, task.place, task.primitive);
    for (const glm::dmat4& transform : transforms) {
        Copy copy{task, *attributes, transform, mesh, mesh.positions.size(), mesh.indices.size()};
        std::vector<std::uint32_t> turned = corners;
        turnMirrored(copy, turned);
        addIndices(copy, turned);
        addPositions(copy);
        addNormals(copy);
        addAllUvs(copy);
        addColors(copy);
        addPart(mesh, copy.firstIndex, material);
    }
}

} // namespace limpid::io
