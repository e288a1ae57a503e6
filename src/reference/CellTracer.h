#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "reference/CellGrid.h"
#include "reference/SceneGeometry.h"
#include "reference/Source.h"
#include "reference/Surface.h"
#include "reference/TexelMap.h"

namespace limpid::reference {

/// Where light went, as whole numbers (Fixed), mean of R, G and B; and the photons that were followed.
struct Tally {
    std::int64_t entering = 0, absorbed = 0, scattered = 0, missed = 0, rejected = 0;
    std::int64_t photons = 0;

    void add(const Tally& other);
};

/// What all photons of one light share. Places are relative to the origin.
struct LightScene {
    const Surface& surface;
    const SceneGeometry& geometry;
    const Shade& shade;
    double level;
    double ior;
    glm::dvec3 absorption, scattering; ///< 1/m
    Fixed fixed;
    std::vector<std::array<TexelMap*, 5>> maps; ///< of each receiver by facing; null where there is none
    double photonsPerTexel; ///< plain ones that are to meet a texel where cells straddle an edge, of one grid
};

/// Follows the light of one source through the cells of a grid. A cell is a photon that carries its
/// footprint: rays refracted at the analytic surface. Four cells by four are taken as one where the rays at
/// its corners and one at random land on one smooth face: then the footprints of its cells are cut with that
/// face and deposited by area. Where they do not, the group is split, and in the end a cell is replaced by
/// plain photons, each on its own way. One object for each thread.
class CellTracer {
  public:
    /// Cells on a side of a group and of a tile.
    static constexpr int group = 4, tile = 32;

    CellTracer(const LightScene& scene, Tally& tally);

    /// The cells of tile `at` of the grid.
    void trace(const CellGrid& grid, const Source& source, glm::ivec2 at);

  private:
    /// A ray that enters the water.
    struct Ray {
        glm::dvec3 from{0}, direction{0, -1, 0};
        double transmittance = 0; ///< after Fresnel and a spot's cone
        bool facing = false;      ///< the surface faces the light there
    };
    enum class Fate { Untraced, Dark, Missed, Landed };
    struct Traced {
        Ray ray;
        Fate fate = Fate::Untraced;
        Hit hit;
        TexelMap* map = nullptr; ///< that shows the face, from the side that is lit
    };
    /// Where the rays of a group land, as its map sees it.
    struct Landings {
        static constexpr std::size_t most = (group + 1) * (group + 1);
        std::array<MapPlace, most> places;
        std::array<glm::dvec3, most> left; ///< share of RGB that the water leaves
        MapSurface surface;

        static std::size_t index(glm::ivec2 corner) { return std::size_t(corner.y * (group + 1) + corner.x); }
    };

    Ray enter(const glm::dvec2& place) const;
    void follow(Traced& traced) const;
    Traced& corner(int x, int y);
    const Traced& cornerOf(glm::ivec2 at) const;
    void traceCells(glm::ivec2 at, int count);
    bool agree(const Traced& a, const Traced& b, double extent, double slack = 1) const;
    bool smooth(const Traced& a, const Traced& b, double extent, double slack) const;
    double extentOf(glm::ivec2 at, int count) const;
    Traced traceAt(glm::ivec2 at, int count, const glm::dvec2& share) const;
    void settleAtOnce(glm::ivec2 at, int count, const Traced& sample);
    void settleOnHidden(glm::ivec2 at, int count, const Traced& sample);
    double groupFlux(glm::ivec2 at, int count) const;
    Landings landingsOf(glm::ivec2 at, int count, const Traced& sample) const;
    void deposit(glm::ivec2 at, int count, const Traced& sample);
    void plainPhotons(glm::ivec2 at);
    int plainCount(glm::ivec2 at) const;
    double cellArea(glm::ivec2 at) const;
    std::uint64_t randomOf(glm::ivec2 at, int use) const;
    double cellFlux(glm::ivec2 at, bool upper) const;
    void land(const Traced& traced, double flux);
    glm::dvec3 remaining(double distance) const;
    void countLost(const glm::dvec3& gone);

    const LightScene& _scene;
    Tally& _tally;
    const Source* _source = nullptr;
    glm::dvec3 _extinction;
    glm::ivec2 _first{0};                ///< cell of the tile's corner
    glm::ivec2 _cells{0};                ///< of this tile
    std::array<double, tile + 1> _x, _z; ///< lines
    std::uint64_t _seed = 0;
    std::vector<Traced> _corners;
};

} // namespace limpid::reference
