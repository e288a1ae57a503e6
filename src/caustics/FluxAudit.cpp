#include "caustics/FluxAudit.h"

#include <algorithm>

namespace limpid {

namespace {

constexpr int groupSize = 64;
constexpr int raysPerBeam = 16;
constexpr int beamsAtOnce = 65536; // bounds the landings to 16 MiB
enum LandUniform { RayCount, LandFirstTriangle, LandRaysPerBeam, Farthest };
enum PlaceUniform {
    BeamCount,
    PlaceFirstTriangle,
    PlaceRaysPerBeam,
    ReceiverNumber,
    Strength,
    Absorption,
    Scattering
};

double meanOf(const glm::dvec3& rgb) {
    return (rgb.x + rgb.y + rgb.z) / 3;
}

} // namespace

FluxAudit::FluxAudit(gl::Context& context)
    : _context(context), _land({"caustics/landings.comp"}), _place({"caustics/place.comp"}) {}

void FluxAudit::place(int firstTriangle, int beamCount, int receiverNumber) {
    _place.set(BeamCount, beamCount);
    _place.set(PlaceFirstTriangle, firstTriangle);
    _place.set(PlaceRaysPerBeam, raysPerBeam);
    _place.set(ReceiverNumber, receiverNumber);
    _place.dispatch(beamCount, groupSize);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

FluxBalance FluxAudit::count(const Beams& beams, const WaterMesh& surface, const Water& water,
                             const gl::Texture& sceneDepth, std::span<const LevelMap* const> maps,
                             double farthest) {
    FluxBalance balance;
    for (const float flux : beams.flux.read<float>(std::size_t(beams.triangleCount)))
        balance.entering += double(flux) * meanOf(beams.strength);
    if (balance.entering == 0) return balance;

    gl::Ledger& ledger = _context.ledger();
    const int atOnce = std::min(beams.triangleCount, beamsAtOnce);
    const gl::Buffer landings(ledger, "flux audit", std::int64_t(atOnce) * raysPerBeam * 16);
    gl::Buffer counts(ledger, "flux audit", std::int64_t(beams.triangleCount) * 16);
    counts.clearToZero();
    _place.set(Strength, glm::vec3(beams.strength));
    _place.set(Absorption, glm::vec3(water.absorption));
    _place.set(Scattering, glm::vec3(water.scattering));
    beams.frame.bindUniform(0);
    surface.indices.bindStorage(0);
    beams.origins.bindStorage(3);
    beams.directions.bindStorage(4);
    beams.flux.bindStorage(5);
    landings.bindStorage(6);
    counts.bindStorage(7);
    for (int first = 0; first < beams.triangleCount; first += atOnce) {
        const int beamCount = std::min(atOnce, beams.triangleCount - first);
        sceneDepth.bind(1);
        _land.set(RayCount, beamCount * raysPerBeam);
        _land.set(LandFirstTriangle, first);
        _land.set(LandRaysPerBeam, raysPerBeam);
        _land.set(Farthest, float(farthest));
        _land.dispatch(std::int64_t(beamCount) * raysPerBeam, groupSize);
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
        place(first, beamCount, -1);
        for (std::size_t i = 0; i < maps.size(); ++i) {
            if (!maps[i]) continue;
            maps[i]->box.bindUniform(1);
            maps[i]->position.bind(0);
            maps[i]->diffuse.bind(1);
            maps[i]->normal.bind(2);
            place(first, beamCount, int(i));
        }
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
                     double texelArea) {
    double sum = 0;
    for (std::size_t i = 0; i < normalDotAxis.size(); ++i) {
        if (normalDotAxis[i] <= 0) continue;
        const double mean = meanOf({irradiance[3 * i], irradiance[3 * i + 1], irradiance[3 * i + 2]});
        sum += mean * texelArea / double(normalDotAxis[i]);
    }
    return sum;
}

} // namespace limpid
