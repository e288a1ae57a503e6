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
/// footprint: rays refracted at the analytic surface, followed through sheets, which take their share, to
/// what takes the rest. Four cells by four are taken as one where the rays at
/// its corners and one at random land on the same smooth faces: then the footprints of its cells are cut with
/// those faces and deposited by area. Where they do not, the group is split, and in the end a cell is
/// replaced by plain photons, each on its own way. One object for each thread.
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
    /// What becomes of what the landings let through. Dark: no light comes to the surface.
    enum class Fate { Untraced, Dark, Missed, Landed };
    /// A face on a ray's way.
    struct Landing {
        Hit hit;
        TexelMap* map = nullptr; ///< that shows the face, from the side that is lit
    };
    struct Traced {
        Ray ray;
        Fate fate = Fate::Untraced;
        glm::dvec3 lit{1};             ///< share of the light that comes to the surface
        std::vector<Landing> landings; ///< sheets as light passes them, then what takes the rest
    };
    /// How far apart the corners of a group land, m, by landing.
    using Extents = std::array<double, mostSheets>;
    /// Of a group by corner, (group + 1) in a row.
    static constexpr std::size_t mostCorners = (group + 1) * (group + 1);
    using Shares = std::array<glm::dvec3, mostCorners>; ///< of the light that comes to the surface, RGB
    /// Where the rays of a group land, as a map sees it.
    struct Landings {
        std::array<MapPlace, mostCorners> places;
        std::array<double, mostCorners> distances; ///< m
        Shares transmittance;
        MapSurface surface;
    };
    /// Light of a group on its way.
    struct Going {
        Shares shares;
        std::array<double, mostCorners> passed{}; ///< m
    };
    static std::size_t cornerIndex(glm::ivec2 corner) {
        return std::size_t(corner.y * (group + 1) + corner.x);
    }

    Ray enter(const glm::dvec2& place) const;
    void follow(Traced& traced) const;
    Traced& corner(int x, int y);
    const Traced& cornerOf(glm::ivec2 at) const;
    void traceCells(glm::ivec2 at, int count);
    TexelMap* mapOf(const Hit& hit, const glm::dvec3& direction) const;
    bool agree(const Traced& a, const Traced& b, const Extents& extents, double slack = 1) const;
    bool smooth(const Traced& a, const Traced& b, std::size_t landing, double extent, double slack) const;
    Extents extentsOf(glm::ivec2 at, int count) const;
    Traced traceAt(glm::ivec2 at, int count, const glm::dvec2& share) const;
    void settleAtOnce(glm::ivec2 at, int count, const Traced& sample);
    void settleOnHidden(glm::ivec2 at, int count, const Traced& sample);
    double groupFlux(glm::ivec2 at, int count) const;
    Landings landingsOf(glm::ivec2 at, int count, const Traced& sample, std::size_t landing) const;
    template <typename Visit>
    static void forEachCorner(int count, const Visit& visit);
    template <typename Visit>
    void forEachHalf(glm::ivec2 at, int count, const Visit& visit) const;
    void deposit(glm::ivec2 at, int count, const Traced& sample);
    void depositOn(glm::ivec2 at, int count, const Traced& sample, std::size_t landing, Going& going);
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
