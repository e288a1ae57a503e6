#pragma once
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "scene/Mesh.h"

namespace limpid {

/// For each position the index of one that lies at the very same place, the same for all of them. Meshes part
/// their vertices where normals or texture coordinates change.
std::vector<std::uint32_t> placesOf(const std::vector<glm::dvec3>& positions);

/// Leaves out triangles of a part that lie where another one of it does, wound either way: files give both
/// sides of a sheet. Every face is seen and lit from both sides, and light must be added to it once.
void dropRepeatedTriangles(Mesh& mesh);

} // namespace limpid
