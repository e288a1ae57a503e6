#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace limpid::models {

/// Triangles, counter-clockwise seen from outside. One normal a position; both in double precision until
/// they are written, so that rounding happens once. Colours (albedo, linear RGB) are one a position or none.
struct Mesh {
    std::vector<glm::dvec3> positions;
    std::vector<glm::dvec3> normals;
    std::vector<glm::dvec3> colours;
    std::vector<std::uint32_t> indices;
};

/// A surface that is not lit yet: positions and triangles, and colours as in a mesh.
struct Shell {
    std::vector<glm::dvec3> positions;
    std::vector<glm::dvec3> colours;
    std::vector<std::uint32_t> indices;
};

/// Adds a shell with smooth normals: at each vertex the mean of its triangles' normals, weighted by their
/// angle there (Thürmer and Wüthrich 1998). By area, the way a quad is cut in two would tilt the thin edge of
/// a fin.
void appendSmooth(Mesh& mesh, const Shell& shell);

/// Adds a shell whose edges are smooth where its faces meet at less than `crease` degrees, and sharp
/// elsewhere: a corner's normal is the mean of those faces around its vertex that are within that angle of
/// its own. It has thus never a normal on the wrong side, thin as the shell may be. Below 90.
void appendCreased(Mesh& mesh, const Shell& shell, double crease = 40.0);

/// Adds a flat quad as two triangles; the corners run counter-clockwise seen from outside.
void appendQuad(Mesh& mesh, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                const glm::dvec3& d);

/// The model as it is committed: longest extent 1 m, base at y = 0, centred in x and z; coordinates rounded
/// to `step`; vertices that are then equal in position, normal and colour are one; triangles without area are
/// gone.
///
/// The rounding is what makes the files equal on every machine: libraries' sines differ in the last bit.
Mesh finished(const Mesh& mesh, double step = 1e-6);

} // namespace limpid::models
