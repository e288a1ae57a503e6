#pragma once
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "water/Beams.h"

namespace limpid {

/// A ray of a beam below the surface.
struct BeamRay {
    std::size_t triangle = 0;
    glm::dvec3 from{0};      ///< on the surface, m from the scene's origin
    glm::dvec3 direction{0}; ///< unit
};

/// The beams of one light, read back: the very prisms that maps are filled with (water/Beams.h). Their flux
/// is laid end to end, triangle by triangle, so that a number in [0, 1) names a ray and equal steps have
/// equal flux.
class BeamRays {
  public:
    /// As Beams and WaterMesh have them, by vertex and by triangle.
    struct Data {
        std::vector<glm::vec4> origins, directions;
        std::vector<std::uint32_t> indices;
        std::vector<float> flux, lit;
    };
    explicit BeamRays(Data data);

    /// Flux of all beams, less what things above the water take; m² or sr.
    double flux() const { return _until.empty() ? 0 : _until.back(); }
    /// The ray at `place` in [0, 1) of the flux. Neighbouring places are neighbouring rays.
    BeamRay at(double place) const;
    /// A ray of one triangle: `place` in [0, 1).
    BeamRay within(std::size_t triangle, double place) const;
    /// Share of the triangle's flux that things above the water leave, [0, 1].
    float lit(std::size_t triangle) const { return _data.lit[triangle]; }

  private:
    Data _data;
    std::vector<double> _until; ///< flux of the triangles up to this one, itself included
};

/// Waits for the GPU.
BeamRays readBeams(const Beams& beams, const WaterMesh& surface);

/// A point of the triangle as barycentric coordinates, for `place` in [0, 1): base-4 digits choose among the
/// four halves of the sides' triangles (Basu and Owen 2015), so that each interval is one compact piece of as
/// much area.
glm::dvec3 trianglePlace(double place);

} // namespace limpid
