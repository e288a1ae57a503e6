#pragma once
#include <memory>
#include <vector>

#include <glm/glm.hpp>

#include "reference/WaveTile.h"
#include "scene/Scene.h"

namespace limpid::reference {

/// The water's surface as a function, in double precision: what the scene's waves mean, evaluated anew. Only
/// what cannot be had twice is shared with the GPU: the noise's gradients, a height map's coefficients and
/// the modes of a spectrum.
class Surface {
  public:
    /// The waves at `time` (s); places are relative to `origin` (m, in the world).
    Surface(const Water& water, const glm::dvec3& origin, double time);

    struct Point {
        double height = 0;     ///< over the mean level, m
        glm::dvec2 slope{0};   ///< dy/dx, dy/dz
        glm::dvec3 up() const; ///< unit normal
    };
    /// `place`: x and z.
    Point at(const glm::dvec2& place) const;

    /// Bounds that hold everywhere: height over the level in m, slope, the shortest wave in m (0: flat).
    double highest() const { return _highest; }
    double steepest() const { return _steepest; }
    double shortest() const { return _shortest; }

  private:
    struct Sine { ///< cosine and circular waves
        double amplitude, wavenumber, phase;
        glm::dvec2 place; ///< unit direction, or the centre
        bool circular;
    };
    struct Noise {
        double amplitude, cells; ///< m; cells a metre
        glm::dvec3 offset;       ///< of place (0, 0) and the time, in its cell
        glm::ivec3 cell;
        int octaves, seed;
    };
    struct Heights {
        std::shared_ptr<const HeightField> field;
        double amplitude;
        glm::dvec2 corner, texels; ///< m; texels a metre
    };

    struct Tile {
        std::shared_ptr<const WaveTile> waves;
        double amplitude;
        glm::dvec2 corner; ///< place (0, 0) in the tile, m
    };

    void add(const Wave& wave, const glm::dvec3& origin, double time);
    void addHeights(const Wave& wave, const glm::dvec3& origin, double time);
    void bound(double height, double slope, double wavelength);
    static void addSine(const Sine& sine, const glm::dvec2& place, Point& sum);
    static void addNoise(const Noise& noise, const glm::dvec2& place, Point& sum);
    static void addField(const Heights& heights, const glm::dvec2& place, Point& sum);

    std::vector<Sine> _sines;
    std::vector<Noise> _noises;
    std::vector<Heights> _heights;
    std::vector<Tile> _tiles;
    double _highest = 0, _steepest = 0, _shortest = 0;
};

} // namespace limpid::reference
