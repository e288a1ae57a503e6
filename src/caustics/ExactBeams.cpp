#include "caustics/ExactBeams.h"

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace limpid {

namespace {

enum Uniform {
    Quads,
    StepsPerFlux,
    ExtinctionPerMetre,
    MetresBefore,
    TestOcclusion,
    TestSurfaceShadow,
    ReceiverNumber
};
enum ResolveUniform { WattsPerStep, Channels };
constexpr int groupSize = 64;
constexpr glm::ivec2 resolveGroupSize{8, 8};

/// Steps of a sum for the light of one unfocused texel: rounding is then below a float's, and the lower word
/// holds a thousandfold focus.
constexpr double stepsPerTexel = 1 << 22;

/// Tiles of large beams that wait for their pass: 1 MiB of them. Beyond, beams are walked where they are.
constexpr std::int64_t mostTiles = 65536;
constexpr int largeGroups = 512;

bool isGrey(const glm::dvec3& v) {
    return v.x == v.y && v.y == v.z;
}

/// What one unit of a beam's flux is spread over, in its unit: the area of a texel, m², or the solid angle
/// that it has about at the lamp, sr.
double unfocusedFlux(const LevelMap& map, const Light& light) {
    const double area = map.frame.texelArea();
    if (light.type == LightType::Directional) return area;
    const glm::dvec3 away = map.frame.box.center() - light.position;
    return area / std::max(glm::dot(away, away), 1e-12);
}

} // namespace

ExactBeams::ExactBeams(gl::Context& context)
    : _context(context), _footprints(context), _resolve({"caustics/resolve_sums.comp"}) {}

const gl::Program& ExactBeams::program(const Variant& variant) {
    std::optional<gl::Program>& program =
        _programs[std::size_t(variant.paths) + 2 * std::size_t(variant.coloured) +
                  4 * std::size_t(variant.large)];
    if (program) return *program;
    std::vector<std::string> defines;
    if (variant.paths) defines.emplace_back("PATHS");
    if (variant.coloured) defines.emplace_back("COLOURED");
    if (variant.large) defines.emplace_back("LARGE");
    return program.emplace(std::initializer_list<const char*>{"caustics/exact_beams.comp"}, defines);
}

void ExactBeams::reserveSums(std::int64_t count) {
    const std::int64_t bytes = 8 * count;
    if (_sums.bytes() >= bytes) return;
    _sums = gl::Buffer(_context.ledger(), "flux sums", bytes);
    _sums.clearToZero();
}

void ExactBeams::deposit(const Inputs& inputs, bool coloured, double stepsPerFlux) {
    const glm::dvec3 extinction = inputs.water.absorption + inputs.water.scattering;
    const bool paths = extinction != glm::dvec3(0) || inputs.sceneDepth || inputs.beams.surfaceShadow;
    _footprints.updateRays(inputs.beams, inputs.surface, inputs.map);
    if (!_largeBeams.id()) _largeBeams = gl::Buffer(_context.ledger(), "large beams", 16 * (mostTiles + 1));
    constexpr std::int32_t none[4] = {};
    _largeBeams.write(0, sizeof(none), none);
    inputs.map.box.bindUniform(1);
    inputs.planes.planes.bind(0);
    inputs.planes.depthPyramid.bind(2);
    inputs.beams.flux.bindStorage(5);
    _footprints.rays().bindStorage(6);
    _footprints.originDepths().bindStorage(7);
    _sums.bindStorage(8);
    _largeBeams.bindStorage(9);
    inputs.beams.frame.bindUniform(0);
    inputs.map.normal.bind(7);
    if (inputs.sceneDepth) inputs.sceneDepth->bind();
    if (inputs.beams.surfaceShadow) inputs.beams.surfaceShadow->bind(surfaceShadowUnit);
    for (const bool large : {false, true}) {
        const gl::Program& deposit = program({paths, coloured, large});
        deposit.set(Quads, inputs.surface.quads);
        deposit.set(StepsPerFlux, float(stepsPerFlux));
        if (paths) {
            deposit.set(ExtinctionPerMetre, glm::vec3(extinction));
            deposit.set(MetresBefore, 0.0f);
            deposit.set(TestOcclusion, inputs.sceneDepth ? 1 : 0);
            deposit.set(ReceiverNumber, inputs.receiverNumber);
            deposit.set(TestSurfaceShadow, inputs.beams.surfaceShadow ? 1 : 0);
        }
        const std::int64_t quads = std::int64_t(inputs.surface.quads.x) * inputs.surface.quads.y;
        deposit.dispatch(large ? largeGroups * groupSize : quads, groupSize);
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    }
}

void ExactBeams::fill(CausticMap& caustics, const Inputs& inputs) {
    caustics.resize(_context, inputs.map.frame.size);
    const glm::ivec2 size = inputs.map.frame.size;
    const bool coloured = !isGrey(inputs.water.absorption + inputs.water.scattering);
    const int channels = coloured ? 3 : 1;
    reserveSums(std::int64_t(size.x) * size.y * channels);
    const double perStep = unfocusedFlux(inputs.map, inputs.light) / stepsPerTexel;
    if (inputs.beams.strength != glm::dvec3(0)) deposit(inputs, coloured, 1 / perStep);

    inputs.map.box.bindUniform(1);
    inputs.map.normal.bind(0);
    caustics.irradiance.bindImage(0, GL_WRITE_ONLY);
    _sums.bindStorage(8);
    _resolve.set(WattsPerStep, glm::vec3(inputs.beams.strength * (perStep / inputs.map.frame.texelArea())));
    _resolve.set(Channels, channels);
    _resolve.dispatch2D(size, resolveGroupSize);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

} // namespace limpid
