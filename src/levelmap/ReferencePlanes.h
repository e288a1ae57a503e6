#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/ShaderData.h"

namespace limpid {

/// One plane to draw: `index` is what texels that belong to it carry, `depth` its distance from the box's
/// near face along the light, m.
struct ReferencePlane {
    int index = 0;
    double depth = 0;
};

/// All planes of a box of `height` m: `count` of them, both faces included; one lies in the middle (thesis
/// 4-6 to 4-9 with N planes in place of n pieces).
std::vector<ReferencePlane> uniformPlanes(double height, int count);

/// Smart slicing, automatic: the planes of `uniformPlanes` that some texel belongs to. `histogram[i]` counts
/// the texels of plane i. Changes no texel's plane, so the result is bit for bit that of all planes.
std::vector<ReferencePlane> occupiedPlanes(double height, std::span<const std::uint32_t> histogram);

using gpu::SubBox;

/// Smart slicing as the thesis has it: neighbouring levels with texels form a sub-box; each gets
/// n = hr / (2 ε) planes (eq. 4-22), rounded up, at least one. `histogram[i]` counts texels of depth level i,
/// `threshold` is ε as a share of the box's height. Planes move, so results differ from uniform slicing.
std::vector<SubBox> subBoxes(double height, std::span<const std::uint32_t> histogram, double threshold);

std::vector<ReferencePlane> planesOf(std::span<const SubBox> boxes);

} // namespace limpid
