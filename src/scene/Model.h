#pragma once
#include <vector>

#include "scene/Mesh.h"
#include "scene/Scene.h"

namespace limpid {

/// What a model file holds besides triangles, all of it in the model's own space.
struct Model {
    Mesh mesh;
    std::vector<Light> lights;
    std::vector<Camera> cameras; ///< each with a position and a target
};

} // namespace limpid
