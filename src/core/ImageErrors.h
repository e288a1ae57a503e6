#pragma once
#include <span>

#include <glm/glm.hpp>

namespace limpid {

/// CIE 1976 L*, u*, v* of a linear Rec. 709 colour, white point D65 (CIE 15:2004). Negative and NaN
/// components count as 0.
glm::dvec3 luvFromLinear(const glm::dvec3& rgb);

/// Average intensity difference of two images, thesis eq. 2-9: the mean over object pixels of the distance in
/// CIE Luv. `a` and `b`: linear RGB, 3 floats a pixel; `mask`: one float a pixel, > 0 on the object, or empty
/// for all. 0 where no pixel is on the object.
double luvDifference(std::span<const float> a, std::span<const float> b, std::span<const float> mask = {});

} // namespace limpid
