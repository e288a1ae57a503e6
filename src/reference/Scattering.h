#pragma once
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "scene/Scene.h"

/// Ground truth for shafts of light: sunlight that the water scatters once towards a camera below the
/// surface.
namespace limpid::reference {

/// A pinhole camera under water. Places are relative to the job's origin, m; directions unit and across each
/// other.
struct ScatterView {
    glm::dvec3 position{0}, right{1, 0, 0}, up{0, 1, 0}, forward{0, 0, -1};
    double verticalFov = 45; ///< degrees
    glm::ivec2 size{64, 64}; ///< pixels
    double aspect() const { return double(size.x) / size.y; }
};
/// The scene's camera, which has position and target.
ScatterView scatterView(const Camera& camera, const glm::dvec3& origin, glm::ivec2 size);

struct ScatterJob {
    const Scene& scene;
    double time = 0;                      ///< s
    glm::dvec3 origin{0};                 ///< m in the world
    glm::dvec2 patchMin{0}, patchSize{1}; ///< surface that light is followed from: x, z, m, in the world
    std::int64_t photons = 0;             ///< for each light
    std::uint64_t seed = 1;
    int threads = 0; ///< 0: as many as the machine has
};

struct ScatterImage {
    glm::ivec2 size{0};
    /// W/(m² sr), mean over the pixel, rows from the top. What reaches the camera of light scattered once on
    /// the way of a view ray to the first receiver or, without one, as far as light is left.
    std::vector<glm::dvec3> radiance;
    /// The nMAE (mean absolute error over the mean) that a perfect image would show against this one, from
    /// the spread of eight independent estimates.
    double standardError = 0;
};

/// Photons are followed from the surface to what they meet; each length of their paths sends its share of the
/// light to the camera, by the phase function, extinction both ways, and what is in between. Lengths are
/// drawn evenly in the angle that the camera sees them under (Kulla and Fajardo 2012), which takes the square
/// of the distance out of the estimate. What the surface mirrors is not followed. The same job gives the same
/// bits, whatever the number of threads.
ScatterImage scatteredLight(const ScatterView& view, const ScatterJob& job);

/// Henyey and Greenstein 1941, 1/sr, over the cosine of the angle between the ways before and after.
double phase(double cosTurn, double anisotropy);

} // namespace limpid::reference
