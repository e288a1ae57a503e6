#pragma once
#include "gl/Handles.h"

namespace limpid {

/// The slice images of one receiver and light: layer i holds what of the receiver is nearest to plane i. All
/// exist at once, 32 bytes a texel and plane. Frame and rows are those of the receiver's level map.
struct Slices {
    gl::Texture position, diffuse, normal; ///< as in LevelMap; -1 where the slab holds no surface
    gl::Texture caustics;                  ///< RGBA32F: irradiance, W/m² on the receiver's own surface

    int count() const { return position.layers(); }
};

} // namespace limpid
