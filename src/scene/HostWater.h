#pragma once
#include <cstdint>

#include "scene/Scene.h"

namespace limpid {

/// Water whose heights a host keeps in an OpenGL texture of its own and may change before every update; they
/// stay on the GPU. The surface is the bicubic spline through the texels' middles. Beyond the texture the
/// heights at its edge go on.
struct HostWater {
    /// GL_TEXTURE_2D of format GL_R32F, level 0: m above Water::level. Texel (0, 0) lies at the least x and
    /// z; x grows along a row, z from row to row. It exists as long as a scene with it is set.
    std::uint32_t texture = 0;
    glm::ivec2 texels{0}; ///< its size, [16, 8192] a side; wavelengths of 8 texels and more are well rendered
    glm::dvec2 center{0}; ///< x and z of its middle, m
    glm::dvec2 size{2};   ///< m along x and z, > 0
    double highest = 0.1; ///< m, > 0: no height, up or down, exceeds it
    double steepest =
        0.5; ///< rise over run, > 0: no slope exceeds it; steeper places may lose light at the rim
};

/// The heights as a wave of the scene, alone or beside others; at most maxHeightMaps such waves. Its
/// amplitude, 1, scales the texture's metres. Made once and kept: another call gives a wave that counts as
/// changed. Throws InputError (expected, got) for numbers out of range.
Wave waveOf(const HostWater& water);

} // namespace limpid
