#pragma once

#include "Mesh.h"

#include <filesystem>
#include <string>

namespace limpid::models {

/// A diffuse material. `colour` is the albedo, linear RGB.
struct Material {
    glm::vec3 colour{0.8f};
    float roughness = 0.7f;
};

/// Writes a binary glTF 2.0 file with one mesh of one primitive: 16-bit indices, then float positions, then
/// float normals, then, if the mesh has any, 16-bit colours, which glTF multiplies with the material's.
/// Throws std::runtime_error if the file cannot be written or the mesh has too many vertices.
void writeGlb(const std::filesystem::path& path, const std::string& name, const Mesh& mesh,
              const Material& material);

} // namespace limpid::models
