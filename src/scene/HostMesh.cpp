#include "scene/HostMesh.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/Error.h"
#include "scene/Shapes.h"

namespace limpid {

namespace {

[[noreturn]] void fail(const char* member, const std::string& expected, const std::string& got) {
    throw InputError(fmt::format("HostMesh::{}: expected {}, got {}", member, expected, got));
}

/// Of bytes, in the words that shaders read.
void requireWords(const char* member, std::int64_t bytes, std::int64_t least) {
    if (bytes < least || bytes % 4 != 0)
        fail(member, fmt::format("a multiple of 4, at least {}", least), fmt::format("{}", bytes));
}

/// Three floats at `offset` of a vertex.
void requireInside(const char* member, int offset, int stride) {
    requireWords(member, offset, 0);
    if (offset + 12 > stride)
        fail(member, fmt::format("at most {} in a vertex of {} bytes", stride - 12, stride),
             fmt::format("{}", offset));
}

void requireIndices(const HostMesh& mesh) {
    const int corners = mesh.indexBuffer ? mesh.indexCount : mesh.vertexCount;
    if (corners < 3 || corners % 3 != 0)
        fail(mesh.indexBuffer ? "indexCount" : "vertexCount", "a multiple of 3, at least 3",
             fmt::format("{}", corners));
    if (!mesh.indexBuffer && mesh.indexCount != 0)
        fail("indexCount", "0 without an index buffer", fmt::format("{}", mesh.indexCount));
    requireWords("indexOffset", mesh.indexOffset, 0);
    if (mesh.indexBytes != 2 && mesh.indexBytes != 4)
        fail("indexBytes", "4 or 2", fmt::format("{}", mesh.indexBytes));
}

void requireBounds(const Bounds& bounds) {
    for (int c = 0; c < 3; ++c)
        if (!(bounds.min[c] <= bounds.max[c]) || !std::isfinite(bounds.max[c] - bounds.min[c]))
            fail("bounds", "finite numbers, min <= max",
                 fmt::format("{} and {}", bounds.min[c], bounds.max[c]));
}

/// A box with each corner once; flat bounds give a plane, or the same faces twice would be a solid of none.
Mesh boxOf(const Bounds& bounds) {
    Mesh mesh = makeBox(glm::dvec3(1), glm::vec3(0.8f));
    for (glm::dvec3& p : mesh.positions)
        p = bounds.center() + p * bounds.size();
    return mesh;
}

} // namespace

Receiver receiverOf(const std::string& name, const HostMesh& mesh) {
    if (mesh.vertexBuffer == 0) fail("vertexBuffer", "an OpenGL buffer", "0");
    requireWords("vertexOffset", mesh.vertexOffset, 0);
    requireWords("vertexStride", mesh.vertexStride, 12);
    requireInside("positionOffset", mesh.positionOffset, mesh.vertexStride);
    if (mesh.normalOffset) requireInside("normalOffset", *mesh.normalOffset, mesh.vertexStride);
    if (mesh.vertexCount < 3) fail("vertexCount", "at least 3", fmt::format("{}", mesh.vertexCount));
    requireIndices(mesh);
    requireBounds(mesh.bounds);
    for (int c = 0; c < 3; ++c)
        if (!(mesh.albedo[c] >= 0 && mesh.albedo[c] <= 1))
            fail("albedo", "numbers in [0, 1]", fmt::format("{}", mesh.albedo[c]));
    Receiver receiver;
    receiver.name = name;
    receiver.mesh = mesh.hull ? mesh.hull : std::make_shared<const Mesh>(boxOf(mesh.bounds));
    receiver.host = std::make_shared<const HostMesh>(mesh);
    return receiver;
}

} // namespace limpid
