#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "core/OrientedBox.h"
#include "reference/FaceSorting.h"
#include "reference/SceneGeometry.h"

namespace limpid::reference {

/// A map that is asked for: which faces it shows, and its texels.
struct MapRequest {
    int receiver = 0;
    int light = 0;
    int facing = 0; ///< 0 the map along the light, k a side map
    FaceSorting faces;
    TexelFrame frame; ///< in the world
};

/// Watts as whole numbers, so that their sum does not depend on its order.
struct Fixed {
    double perWatt = 1;

    std::int64_t of(double watts) const { return std::int64_t(watts * perWatt + 0.5); } ///< `watts` >= 0
    double watts(std::int64_t fixed) const { return double(fixed) / perWatt; }
};

/// Faces whose gradients differ by more in m by m are told apart within a texel: what a wall takes is not
/// what the floor beside it has.
inline constexpr double mostCrease = 4;

/// A place in a map: texels from its corner in u and w, depth along its axis in m.
using MapPlace = glm::dvec3;

/// The surface that light lands on, as a map sees it.
struct MapSurface {
    glm::dvec2 gradient{0}; ///< depth in m by metre along u and w
    double slack = 0;       ///< m of depth that it may be off, where a footprint spans a curved receiver
    bool spans = false;     ///< whether it is a footprint's, which may span several faces
};

/// Depth in m by metre along u and w of `box`, of a face with this unit normal.
glm::dvec2 depthGradient(const glm::dvec3& normal, const OrientedBox& box);

/// The face that a texel shows at its middle.
struct TexelFace {
    glm::dvec2 middle{0};   ///< texels
    double depth = 0;       ///< m
    glm::dvec2 gradient{0}; ///< m by m

    /// Whether a surface of depth `found` (m) at `at` (texels) is the same one: it lies where the face goes
    /// on to, give or take what a crease inside the texel can make. `texel`: m.
    bool goesOn(const glm::dvec2& at, double found, const MapSurface& surface, double texel) const;
};

/// The light on one map. First `see` for every row, then `findRims` for every row, by any thread; then light
/// is added by any thread, and `closeBatch` called between batches.
class TexelMap {
  public:
    TexelMap(const MapRequest& request, const SceneGeometry& geometry, const glm::dvec3& origin, double level,
             Fixed fixed);

    void see(int row);
    void findRims(int row);

    const MapRequest& request() const { return _request; }
    glm::ivec2 size() const { return _request.frame.size; }
    double texel() const { return _request.frame.texel; }
    const glm::dvec3& axis() const { return _box.t; }
    MapPlace place(const glm::dvec3& point) const;
    /// Depth in m by metre along u and w of a face with this unit normal.
    glm::dvec2 gradient(const glm::dvec3& normal) const;

    /// Adds light (RGB, W) on a surface, at a point or spread evenly over a triangle. Returns
    /// the share that no texel takes.
    double addPoint(const MapPlace& place, const MapSurface& surface, const glm::dvec3& watts);
    double addTriangle(const std::array<MapPlace, 3>& corners, const MapSurface& surface,
                       const glm::dvec3& watts);

    /// What was added since the last call is one of the independent estimates.
    void closeBatch();

    struct Finished {
        std::vector<float> irradiance, position, normal; ///< as in a bake
        double deposited = 0;                            ///< W, mean of R, G and B
        double standardError = 0;                        ///< see reference/Reference.h
    };
    Finished finished() const;

  private:
    struct Texel {
        float depth = 0;       ///< m
        float facing = 0;      ///< |n · axis|, 0 where there is no receiver
        float share = 0;       ///< of the texel that the surface around its middle covers, (0, 1]
        glm::vec2 gradient{0}; ///< m by m
        glm::vec3 normal{0};   ///< unit, facing the box's top
    };

    Texel cast(const glm::dvec2& at) const;
    bool takes(const Texel& texel, const glm::dvec2& middle, const glm::dvec2& at, double depth,
               const MapSurface& surface) const;
    bool isRim(glm::ivec2 at) const;
    double coveredShare(glm::ivec2 at) const;
    bool addToTexel(glm::ivec2 texel, const MapPlace& place, const MapSurface& surface,
                    const glm::dvec3& watts);
    double surfaceArea(const Texel& texel) const;
    std::size_t index(glm::ivec2 at) const {
        return std::size_t(at.y) * std::size_t(size().x) + std::size_t(at.x);
    }

    MapRequest _request;
    const SceneGeometry& _geometry;
    OrientedBox _box; ///< relative to the origin
    double _level;    ///< likewise
    Fixed _fixed;
    std::vector<Texel> _texels;
    std::vector<std::int64_t> _sums; ///< RGB of each texel
    std::vector<double> _before;     ///< mean of R, G and B, W, at the last closeBatch
    std::vector<double> _squares;    ///< of what each batch added, W²
    int _batches = 0;
};

} // namespace limpid::reference
