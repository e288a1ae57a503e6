#include "reference/Scattering.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/Parallel.h"
#include "reference/Random.h"
#include "reference/Refraction.h"
#include "reference/SceneGeometry.h"
#include "reference/Source.h"
#include "reference/Surface.h"

namespace limpid::reference {

namespace {

constexpr int batches = 8;
/// Samples that a path has in the angle that one pixel has in the middle of the picture.
constexpr double samplesPerPixel = 2;
/// Beyond this optical depth nothing is followed: e^-16 is below what eight batches can tell.
constexpr double mostExtinction = 16;

/// A ray of light below the surface, between two faces that it meets.
struct Path {
    glm::dvec3 from, direction; ///< where it enters, m from the origin; unit
    double begin, end;          ///< m from there
    glm::dvec3 flux;            ///< W, without the water's extinction
};

class Scatterer {
  public:
    Scatterer(const ScatterView& view, const ScatterJob& job)
        : _view(view), _job(job), _water(job.scene.water), _surface(_water, job.origin, job.time),
          _geometry(job.scene, job.origin), _level(_water.level - job.origin.y),
          _min(job.patchMin - glm::dvec2(job.origin.x, job.origin.z)),
          _shade(_geometry, _surface, _level, _min, _min + job.patchSize),
          _lost(_water.absorption + _water.scattering),
          _focus(0.5 * view.size.y / std::tan(0.5 * glm::radians(view.verticalFov))) {
        const double least = std::min({_lost.x, _lost.y, _lost.z});
        const double reach = 100 * glm::length(job.patchSize);
        _farthest = least > 0 ? std::min(mostExtinction / least, reach) : reach;
    }

    ScatterImage run();

  private:
    using Sums = std::vector<std::int64_t>;
    void runBatch(int batch, std::vector<Sums>& sums) const;
    void runRow(const Source& source, int batch, int row, glm::ivec2 cells, Sums& sums) const;
    void followThrough(Path path, std::uint64_t seed, Sums& sums) const;
    void follow(const Path& path, std::uint64_t seed, Sums& sums) const;
    void see(const Path& path, double along, double weight, Sums& sums) const;

    const ScatterView& _view;
    const ScatterJob& _job;
    const Water& _water;
    Surface _surface;
    SceneGeometry _geometry;
    double _level;
    glm::dvec2 _min;
    Shade _shade;
    glm::dvec3 _lost; ///< 1/m
    double _focus;    ///< pixels
    double _farthest = 0;
    double _steps = 1; ///< of the integer sums for 1 W/(m² sr)
};

/// What the point `along` m down a path sends to the camera, into the pixel that shows it. `weight`: m/m².
void Scatterer::see(const Path& path, double along, double weight, Sums& sums) const {
    const glm::dvec3 point = path.from + along * path.direction;
    const glm::dvec3 way = point - _view.position;
    const double depth = glm::dot(way, _view.forward), distance = glm::length(way);
    if (depth <= 1e-9) return;
    const glm::dvec2 at(0.5 * _view.size.x + _focus * glm::dot(way, _view.right) / depth,
                        0.5 * _view.size.y - _focus * glm::dot(way, _view.up) / depth);
    const glm::ivec2 pixel(glm::floor(at));
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= _view.size.x || pixel.y >= _view.size.y) return;
    const glm::dvec3 ray = way / distance;
    const glm::dvec3 seen = _geometry.through(_view.position, ray, distance);
    if (seen == glm::dvec3(0)) return;
    const double solidAngle = std::pow(depth / distance, 3) / (_focus * _focus);
    const glm::dvec3 left = seen * glm::exp(-_lost * (along + distance));
    const glm::dvec3 value = path.flux * left * _water.scattering *
                             (phase(-glm::dot(ray, path.direction), _water.anisotropy) * weight / solidAngle);
    const std::size_t first = 3 * (std::size_t(pixel.y) * std::size_t(_view.size.x) + std::size_t(pixel.x));
    for (int c = 0; c < 3; ++c)
        sums[first + std::size_t(c)] += std::llround(value[c] * _steps);
}

void Scatterer::follow(const Path& path, std::uint64_t seed, Sums& sums) const {
    // Seen from the camera, a place of the path is at a tangent of its distance from the foot.
    const double foot = glm::dot(_view.position - path.from, path.direction);
    const double aside = std::max(glm::distance(_view.position, path.from + foot * path.direction), 1e-9);
    const double low = std::atan((path.begin - foot) / aside), high = std::atan((path.end - foot) / aside);
    const int count = std::max(1, int((high - low) * _focus * samplesPerPixel));
    const double step = (high - low) / count;
    for (int i = 0; i < count; ++i) {
        const double angle = low + (i + unit(mixed(seed, std::uint64_t(i)))) * step;
        see(path, foot + aside * std::tan(angle), step / aside, sums);
    }
}

void Scatterer::runRow(const Source& source, int batch, int row, glm::ivec2 cells, Sums& sums) const {
    const glm::dvec2 cell = _job.patchSize / glm::dvec2(cells);
    for (int column = 0; column < cells.x; ++column) {
        const std::uint64_t seed = mixed(mixed(_job.seed, std::uint64_t(batch)),
                                         std::uint64_t(row) * std::uint64_t(cells.x) + std::uint64_t(column));
        const glm::dvec2 xz = _min + cell * (glm::dvec2(column, row) + unitSquare(seed));
        const Surface::Point point = _surface.at(xz);
        const glm::dvec3 place(xz.x, _level + point.height, xz.y);
        const glm::dvec3 incident = source.incident(place);
        const double cosIncident = -glm::dot(incident, point.up());
        const double taken = source.density(place, point.slope);
        if (cosIncident <= 0 || taken <= 0) continue;
        const glm::dvec3 lit = _shade.lit(source, place);
        if (lit == glm::dvec3(0)) continue;
        Path path{place, refracted(incident, point.up(), _water.ior), 0, _farthest, source.strength * lit};
        path.flux *= taken * cell.x * cell.y * transmitted(cosIncident, _water.ior) / double(batches);
        if (source.cosOuter > -2) path.flux *= source.withinCone(incident);
        followThrough(path, mixed(seed), sums);
    }
}

/// The whole of a path, through sheets.
void Scatterer::followThrough(Path path, std::uint64_t seed, Sums& sums) const {
    Hit hit = _geometry.first(path.from, path.direction);
    for (int sheets = 0; path.begin < _farthest && path.flux != glm::dvec3(0); ++sheets) {
        path.end = hit ? std::min(_farthest, hit.distance) : _farthest;
        follow(path, seed + std::uint64_t(sheets), sums);
        if (!hit || sheets == mostSheets) return;
        path.flux *= hit.transmittance;
        path.begin = path.end;
        hit = _geometry.next(path.from, path.direction, hit);
    }
}

void Scatterer::runBatch(int batch, std::vector<Sums>& sums) const {
    const double photons = std::max(double(_job.photons) / batches, 1.0);
    const double across = std::sqrt(photons * _job.patchSize.x / _job.patchSize.y);
    const glm::ivec2 cells(std::max(1, int(std::lround(across))),
                           std::max(1, int(std::lround(photons / std::max(across, 1e-9)))));
    for (const Light& light : _job.scene.lights) {
        const Source source = sourceOf(light, _job.origin, glm::dvec2(0));
        inParallel(cells.y, int(sums.size()), [&](int thread, int row) {
            runRow(source, batch, row, cells, sums[std::size_t(thread)]);
        });
    }
}

ScatterImage Scatterer::run() {
    ScatterImage image{_view.size, {}, 0};
    const std::size_t pixels = std::size_t(_view.size.x) * std::size_t(_view.size.y);
    image.radiance.resize(pixels);
    double most = 0;
    for (const Light& light : _job.scene.lights)
        for (int c = 0; c < 3; ++c)
            most = std::max(most, light.type == LightType::Point ? light.intensity[c] : light.irradiance[c]);
    if (most <= 0 || _water.scattering == glm::dvec3(0)) return image;
    // A thousandfold of the light in a pixel still leaves twelve bits to a word's end.
    _steps = 0x1p41 / most;
    const int threads = threadsOf(_job.threads);
    std::vector<glm::dvec3> squares(pixels);
    for (int batch = 0; batch < batches; ++batch) {
        std::vector<Sums> sums(std::size_t(threads), Sums(3 * pixels, 0));
        runBatch(batch, sums);
        for (std::size_t i = 0; i < pixels; ++i) {
            glm::dvec3 value(0);
            for (const Sums& own : sums)
                value += glm::dvec3(own[3 * i], own[3 * i + 1], own[3 * i + 2]) / _steps;
            image.radiance[i] += value;
            squares[i] += value * value * double(batches) * double(batches);
        }
    }
    double deviation = 0, mean = 0;
    for (std::size_t i = 0; i < pixels; ++i) {
        const glm::dvec3 spread =
            glm::max(squares[i] / double(batches) - image.radiance[i] * image.radiance[i], glm::dvec3(0));
        deviation += glm::dot(glm::sqrt(spread / double(batches - 1)), glm::dvec3(1));
        mean += glm::dot(image.radiance[i], glm::dvec3(1));
    }
    // Of a normal spread, the mean absolute error is √(2/π) of the deviation.
    if (mean > 0) image.standardError = std::sqrt(2 / std::numbers::pi) * deviation / mean;
    return image;
}

} // namespace

double phase(double cosTurn, double anisotropy) {
    const double g = anisotropy, below = 1 + g * g - 2 * g * cosTurn;
    return (1 - g * g) / (4 * std::numbers::pi * below * std::sqrt(below));
}

ScatterView scatterView(const Camera& camera, const glm::dvec3& origin, glm::ivec2 size) {
    ScatterView view;
    view.position = *camera.position - origin;
    view.forward = glm::normalize(*camera.target - *camera.position);
    view.right = glm::normalize(glm::cross(view.forward, camera.up));
    view.up = glm::cross(view.right, view.forward);
    view.verticalFov = camera.verticalFov;
    view.size = size;
    return view;
}

ScatterImage scatteredLight(const ScatterView& view, const ScatterJob& job) {
    return Scatterer(view, job).run();
}

} // namespace limpid::reference
