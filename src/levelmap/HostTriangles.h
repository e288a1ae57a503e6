#pragma once
#include "gl/Context.h"
#include "gl/Handles.h"
#include "scene/HostMesh.h"

namespace limpid {

/// A host's triangles as ReceiverGeometry has its own: vertices in its layout, 32-bit indices.
struct HostTriangles {
    gl::Buffer vertices, indices;
    int indexCount = 0;
};

/// Put into the world by the GPU. The receiver has a host's mesh; `origin`: what positions are relative to,
/// m.
HostTriangles hostTriangles(gl::Context& context, const Receiver& receiver, const glm::dvec3& origin);

/// Positions (own space) and indices in memory, as a mesh of one part without normals. Waits for the GPU.
Mesh readTriangles(const HostMesh& mesh);

} // namespace limpid
