#pragma once
#include <vector>

#include <glm/glm.hpp>

#include "io/gltf/File.h"
#include "io/gltf/Nodes.h"
#include "scene/Scene.h"

namespace limpid::io {

/// The lights of KHR_lights_punctual in the scene. Their intensities are photometric (lux, candela) and
/// exposed as the file's author liked, so only their ratios are kept: the light that is brightest at `center`
/// gives 6 W/m² there, in the strongest of its colours. Spots count as if they looked
/// there. What gives no light is left out. Throws InputError for an index that breaks the format.
std::vector<Light> readLights(const GltfFile& file, const std::vector<SceneNode>& nodes,
                              const glm::dvec3& center);

/// The perspective cameras in the scene. Each looks at the point of its axis that is abreast of `center`, or
/// 1 m ahead if that is behind it. One that cannot see is left out.
std::vector<Camera> readCameras(const GltfFile& file, const std::vector<SceneNode>& nodes,
                                const glm::dvec3& center);

} // namespace limpid::io
