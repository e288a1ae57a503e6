#include "caustics/FluxAudit.h"

#include <algorithm>
#include <array>

namespace limpid {

namespace {

constexpr int groupSize = 64;
constexpr int raysPerBeam = 16;    // as in shaders/include/triangle.glsl
constexpr int beamsAtOnce = 65536; // bounds the landings to 16 MiB
enum LandUniform { RayCount, LandFirstTriangle, Farthest = 3, MetReceiver, EdgesOnly };
constexpr int unplaced = -1; // for the rays that no map has taken
enum PlaceUniform {
    BeamCount,
    PlaceFirstTriangle,
    ReceiverNumber = 3,
    Strength,
    Absorption,
    Scattering,
    MeanShade
};

void bindMap(const LevelMap& map) {
    map.box.bindUniform(1);
    map.position.bind(0);
    map.diffuse.bind(1);
    map.normal.bind(2);
}

double meanOf(const glm::dvec3& rgb) {
    return (rgb.x + rgb.y + rgb.z) / 3;
}

} // namespace

FluxAudit::FluxAudit(gl::Context& context)
    : _context(context), _land({"caustics/landings.comp"}),
      _landOwn({"caustics/landings.comp"}, std::array<std::string, 1>{"OWN_DIRECTION"}),
      _meet({"caustics/landings_facing.comp"}), _place({"caustics/place.comp"}) {}

void FluxAudit::follow(const gl::Program& program, int firstTriangle, int beamCount, double farthest) {
    program.set(RayCount, beamCount * raysPerBeam);
    program.set(LandFirstTriangle, firstTriangle);
    program.set(Farthest, float(farthest));
    program.dispatch(std::int64_t(beamCount) * raysPerBeam, groupSize);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void FluxAudit::place(int firstTriangle, int beamCount, int receiverNumber) {
    _place.set(BeamCount, beamCount);
    _place.set(PlaceFirstTriangle, firstTriangle);
    _place.set(ReceiverNumber, receiverNumber);
    _place.dispatch(beamCount, groupSize);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

FluxBalance FluxAudit::count(const Beams& beams, const WaterMesh& surface, const Water& water,
                             const SceneDepth& sceneDepth, std::span<const Placed> maps, double farthest,
                             Shade shade) {
    FluxBalance balance;
    if (beams.strength == glm::dvec3(0)) return balance;
    const auto flux = beams.flux.read<float>(std::size_t(beams.triangleCount));
    const auto lit = beams.lit.read<float>(std::size_t(beams.triangleCount));
    for (std::size_t i = 0; i < flux.size(); ++i)
        balance.entering += double(flux[i]) * double(lit[i]) * meanOf(beams.strength);
    if (balance.entering == 0) return balance;

    gl::Ledger& ledger = _context.ledger();
    const int atOnce = std::min(beams.triangleCount, beamsAtOnce);
    const gl::Buffer landings(ledger, "flux audit", std::int64_t(atOnce) * raysPerBeam * 16);
    gl::Buffer counts(ledger, "flux audit", std::int64_t(beams.triangleCount) * 16);
    counts.clearToZero();
    const bool own = shade == Shade::Own;
    _place.set(MeanShade, own ? 0 : 1);
    _place.set(Strength, glm::vec3(beams.strength));
    _place.set(Absorption, glm::vec3(water.absorption));
    _place.set(Scattering, glm::vec3(water.scattering));
    beams.frame.bindUniform(0);
    if (beams.surfaceShadow) beams.surfaceShadow->bind(surfaceShadowUnit);
    surface.indices.bindStorage(0);
    beams.origins.bindStorage(3);
    beams.directions.bindStorage(4);
    beams.flux.bindStorage(5);
    landings.bindStorage(6);
    counts.bindStorage(7);
    for (int first = 0; first < beams.triangleCount; first += atOnce) {
        const int beamCount = std::min(atOnce, beams.triangleCount - first);
        sceneDepth.bind();
        follow(own ? _landOwn : _land, first, beamCount, farthest);
        for (const Placed& placed : maps) {
            const bool further = placed.map->facing > 0;
            if (!own && !further) continue;
            _meet.set(EdgesOnly, further ? 0 : 1);
            bindMap(*placed.map);
            _meet.set(MetReceiver, placed.receiver);
            follow(_meet, first, beamCount, farthest);
        }
        for (const bool further : {true, false})
            for (const Placed& placed : maps) {
                if ((placed.map->facing > 0) != further) continue;
                bindMap(*placed.map);
                placed.coverage->bind(4);
                place(first, beamCount, placed.receiver);
            }
        place(first, beamCount, unplaced);
    }
    for (const glm::vec4& c : counts.read<glm::vec4>(std::size_t(beams.triangleCount))) {
        balance.missed += double(c.x);
        balance.rejected += double(c.y);
        balance.absorbed += double(c.z);
        balance.scattered += double(c.w);
    }
    return balance;
}

double depositedFlux(std::span<const float> irradiance, std::span<const float> normalDotAxis,
                     std::span<const float> coverage, double texelArea) {
    double sum = 0;
    for (std::size_t i = 0; i < normalDotAxis.size(); ++i) {
        if (normalDotAxis[i] <= 0) continue;
        const double mean = meanOf({irradiance[3 * i], irradiance[3 * i + 1], irradiance[3 * i + 2]});
        sum += mean * texelArea * double(coverage[i]) / double(normalDotAxis[i]);
    }
    return sum;
}

} // namespace limpid
