#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "core/Bounds.h"
#include "scene/Scene.h"

namespace limpid {

/// Triangles that a host keeps in OpenGL buffers of its own, opaque and of one colour. When a scene with them
/// is set, the GPU puts them into the world: 48 bytes a vertex and 4 an index, no copy through the CPU. What
/// is planned on the CPU takes `hull` for them. Positions and indices are read back once, at an update, where
/// a method asks single beams what is in their way: exact-beam and photon-splat, and any beside sheets that
/// let light through. While a scene with them is set, the buffers exist, unmapped, with the same content.
struct HostMesh {
    std::uint32_t vertexBuffer = 0;
    std::int64_t vertexOffset = 0; ///< bytes to the first vertex, a multiple of 4
    int vertexStride = 12;         ///< bytes from one to the next, a multiple of 4
    int positionOffset = 0;        ///< bytes inside of a vertex, a multiple of 4: three floats, m, own space
    std::optional<int> normalOffset; ///< likewise, shading normals of any length; none: those of the faces
    int vertexCount = 0;             ///< >= 3

    std::uint32_t indexBuffer = 0; ///< 0: three vertices after another are a triangle
    std::int64_t indexOffset = 0;  ///< bytes to the first index, a multiple of 4
    int indexBytes = 4;            ///< of one: 4, or 2 in a buffer of a multiple of 4 bytes
    int indexCount = 0;            ///< a multiple of 3; 0 without an index buffer

    Bounds bounds;                    ///< of all its triangles, m, own space
    std::shared_ptr<const Mesh> hull; ///< closer around them than the bounds, own space; null: the bounds
    /// Whether it encloses a solid, wound counter-clockwise from outside: where the water's surface cuts it
    /// open, no light is in there. Otherwise its faces are lit on both sides.
    bool closed = false;
    /// Whether a twentieth of its surface or more runs along some light: it gets four more maps, which see
    /// such faces.
    bool walls = false;
    glm::vec3 albedo{0.8f}; ///< linear RGB, [0, 1]
};

/// A receiver of the host's triangles, in the world as in their own space. Made once and kept: where the
/// buffers' content has changed, another call gives a receiver that counts as changed. Throws InputError
/// (expected, got) for numbers out of range.
Receiver receiverOf(const std::string& name, const HostMesh& mesh);

} // namespace limpid
