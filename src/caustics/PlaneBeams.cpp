#include "caustics/PlaneBeams.h"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/ShaderData.h"
#include "gl/Bindings.h"

namespace limpid {

namespace {

constexpr glm::ivec2 resolveGroupSize{8, 8};
constexpr glm::vec2 allDepths{-1e29f, 1e29f};

/// More than all flux that may enter: of a directional light, the patch seen along it, m², for waves of
/// slopes up to 3; of a point light, all directions, sr.
double mostFlux(const Light& light, const WaterPatch& patch) {
    return light.type == LightType::Directional ? 4 * patch.size.x * patch.size.y : 4 * std::numbers::pi;
}

/// Steps of the sums for a unit of flux: 2²² for an unfocused texel, so that rounding is below a float's, but
/// no more than keeps 64 bits from wrapping if all the light met in one texel: a beam gives its flux 2¹⁷
/// times to a texel that it covers as a sliver (smallestTwiceArea), and its way is up to 50 times as long as
/// its depth (rayFootprint).
double stepsOf(const PlaneBeams::Inputs& inputs) {
    return std::min(1 / fluxPerStep(inputs.map, inputs.light),
                    std::exp2(64 - 17 - 6) / mostFlux(inputs.light, inputs.patch));
}

} // namespace

PlaneBeams::PlaneBeams(gl::Context& context)
    : _context(context), _sums(context), _resolve({"caustics/resolve_planes.comp"}), _broad(context) {}

const gl::Program& PlaneBeams::program(const Variant& variant) {
    std::optional<gl::Program>& program =
        _programs[std::size_t(variant.paths) + 2 * std::size_t(variant.coloured) +
                  4 * std::size_t(variant.broad)];
    if (program) return *program;
    std::vector<std::string> defines;
    if (variant.paths) defines.emplace_back("PATHS");
    if (variant.coloured) defines.emplace_back("COLOURED");
    if (variant.broad) defines.emplace_back("BROAD");
    return program.emplace(std::initializer_list<const char*>{"caustics/plane_beams.comp"}, defines);
}

void PlaneBeams::bind(const Inputs& inputs) {
    inputs.beams.frame.bindUniform(lightFrameBlock);
    inputs.map.box.bindUniform(boxFrameBlock);
    inputs.depths.pyramid.bind(depthPyramidUnit);
    inputs.map.normal.bind(normalMapUnit);
    inputs.map.position.bind(positionMapUnit);
    inputs.beams.origins.bindStorage(beamOriginsBuffer);
    inputs.beams.directions.bindStorage(beamDirectionsBuffer);
    inputs.beams.flux.bindStorage(beamFluxBuffer);
    if (inputs.beams.surfaceShadow) inputs.beams.surfaceShadow->bind(surfaceShadowUnit);
}

void PlaneBeams::bindSums(const Inputs& inputs) {
    const glm::ivec2 size = inputs.map.frame.size;
    _sums.bind(std::int64_t(size.x) * size.y * channelsOf(inputs.colours, inputs.water));
}

void PlaneBeams::depositBetween(const Inputs& inputs, const glm::vec2& depths) {
    const bool coloured = channelsOf(inputs.colours, inputs.water) > 1;
    const double stepsPerFlux = stepsOf(inputs) / inputs.points;
    const glm::dvec3 extinction = inputs.water.absorption + inputs.water.scattering;
    const bool paths = extinction != glm::dvec3(0) || inputs.beams.surfaceShadow;
    const glm::ivec2 size = inputs.map.frame.size, quads = inputs.surface.quads;
    _broad.clear(std::int64_t(quads.x) * quads.y, std::int64_t(size.x) * size.y);
    _broad.bind();
    for (const bool broad : {false, true}) {
        const gl::Program& program = this->program({paths, coloured, broad});
        program.set(quadsLocation, quads);
        program.set(stepsPerFluxLocation, float(stepsPerFlux));
        program.set(depthLimitsLocation, depths);
        if (paths) {
            program.set(extinctionPerMetreLocation, glm::vec3(extinction));
            program.set(testSurfaceShadowLocation, inputs.beams.surfaceShadow ? 1 : 0);
        }
        if (broad)
            _broad.dispatch(program, gpu::plain + gpu::broad);
        else
            BeamCulling::dispatch(program, inputs.culling, quads);
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT |
                        GL_BUFFER_UPDATE_BARRIER_BIT);
    }
}

void PlaneBeams::deposit(const Inputs& inputs, Dispatch dispatch) {
    if (inputs.beams.strength == glm::dvec3(0)) return;
    bindSums(inputs);
    bind(inputs);
    if (dispatch == Dispatch::Once)
        depositBetween(inputs, allDepths);
    else
        for (const ReferencePlane& plane : inputs.map.planes)
            depositBetween(inputs, glm::vec2(float(plane.depth)));
}

void PlaneBeams::resolve(CausticMap& caustics, const Inputs& inputs) {
    const glm::ivec2 size = inputs.map.frame.size;
    caustics.resize(_context, size);
    bindSums(inputs);
    inputs.map.box.bindUniform(boxFrameBlock);
    inputs.map.diffuse.bind(diffuseMapUnit);
    caustics.irradiance.bindImage(irradianceImage, GL_WRITE_ONLY);
    _resolve.set(wattsPerStepLocation,
                 glm::vec3(inputs.beams.strength / (stepsOf(inputs) * inputs.map.frame.texelArea())));
    _resolve.set(channelsLocation, channelsOf(inputs.colours, inputs.water));
    _resolve.dispatch2D(size, resolveGroupSize);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

} // namespace limpid
