#pragma once

#include "Anatomy.h"
#include "Loft.h"
#include "Place.h"

#include <glm/vec2.hpp>

namespace limpid::models {

/// More parts of animals that swim along +x with y up, for fishes that are to be told apart; body rows are
/// those of Anatomy.h.

/// A fin spread from its root (on or in the body) to its tip, both from front to back and smooth between
/// their points. Its rays wave sideways by `ripple` at the tip, `waves` times; between `spines` spines, if
/// any, the tip is cut in by the share `jag`.
struct Fan {
    std::vector<glm::dvec3> root, tip;
    double halfThickness = 0.006;
    double ripple = 0.0;
    double waves = 3.0;
    int spines = 0;
    double jag = 0.0;
    std::function<glm::dvec3(double u, double v)> colour; ///< u from root to tip, v from front to back
    int nu = 5, nv = 14;
};
Shell fan(const Fan& fan);

/// `base` with `rays` darker rays (none: 0) and towards `edge` at the tip.
std::function<glm::dvec3(double, double)> finColours(unsigned base, unsigned edge, int rays = 0);

/// As body() of Anatomy.h with its rings spread evenly from nose to tail, closer at both, so that a pattern
/// is as fine everywhere; 2 · rings · sides triangles.
Shell evenBody(const std::vector<BodyRow>& rows, int rings, int sides);

/// Where a fish's face has its marks: the gill cover's rear edge, an arc of `gillRadius` around `gill` (x,
/// y), and the mouth, a line from the nose to `mouth` (x, y) with the nose at height `noseY`.
struct Face {
    glm::dvec2 gill;
    double gillRadius;
    glm::dvec2 mouth;
    double noseX, noseY;
};

/// The body with a raised gill cover and a cleft for the mouth, and both drawn dark into its colours.
Shell withFace(Shell body, const Face& face);

/// A pupil in an iris, looking towards +z: 2 · sides · (rows − 1) triangles with 10 rows and 14 sides.
Shell eye(const glm::dvec3& centre, double radius, unsigned iris);

/// A mesh that takes parts through one last shape, such as the bend of a stroke of the tail.
class Assembly {
  public:
    explicit Assembly(std::function<glm::dvec3(const glm::dvec3&)> shape = {}) : _shape{std::move(shape)} {}

    /// One part, or the part and its mirror image in z.
    void add(Shell part, double crease = 40.0);
    void addPair(const Shell& part, double crease = 40.0);

    Mesh take() { return std::move(_mesh); }

  private:
    std::function<glm::dvec3(const glm::dvec3&)> _shape;
    Mesh _mesh;
};

/// The bend of a swimming body: behind `from` the middle swings aside to `reach` at x = −0.5, and lags.
std::function<glm::dvec3(const glm::dvec3&)> swimming(double from, double reach);

} // namespace limpid::models
