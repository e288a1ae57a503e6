#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include <glm/glm.hpp>

namespace limpid {

/// What no height and no slope of a field exceeds.
struct HeightBounds {
    glm::ivec2 size{0};     ///< texels
    double highest = 0;     ///< height, in size
    glm::dvec2 steepest{0}; ///< slope along x and z, height a texel
};

/// Heights on a grid of texels as coefficients of a bicubic B-spline (shaders/optics/spline.glsl), one a
/// texel, row by row: x grows along a row and z from row to row. The spline goes through the heights it was
/// made from, and height, slope and curvature are continuous everywhere: the rate at which a surface focuses
/// light is its curvature, so with anything less smooth the texels would show in the caustics. The two
/// outermost texels all around are 0; that ends the surface at the edge, as smoothly.
struct HeightField : HeightBounds {
    std::vector<float> spline;

    static constexpr int minSide = 8, maxSide = 8192;
};

/// The field of `heights`, size.x · size.y of them, multiplied by a window that falls smoothly to 0 over
/// `fade` texels inside of the edges in x and z.
HeightField makeHeightField(glm::ivec2 size, std::vector<float> heights, const glm::dvec2& fade);

/// Where the frames of a height map come from. All have one size.
class HeightSource {
  public:
    virtual ~HeightSource() = default;
    /// At least 1.
    virtual int frameCount() const = 0;
    /// `index` in [0, frameCount). May take the time to load a file, and throw InputError.
    virtual std::shared_ptr<const HeightField> frame(int index) = 0;
    /// Of the first frame; later ones are taken to be alike.
    virtual const HeightBounds& bounds() const = 0;
    /// Least difference of two heights as the first frame's file stores them; 0 for floating point.
    virtual double step() const { return 0; }
    /// OpenGL texture of a host's that holds the heights in place of frame(), and may hold others at any time
    /// (scene/HostWater.h); 0: none.
    virtual std::uint32_t texture() const { return 0; }
};

} // namespace limpid
