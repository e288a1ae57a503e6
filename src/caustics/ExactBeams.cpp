#include "caustics/ExactBeams.h"

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "core/ShaderData.h"
#include "gl/Bindings.h"

namespace limpid {

namespace {

constexpr glm::ivec2 resolveGroupSize{8, 8};

constexpr gpu::BeamTouches noTouches{{0, 1, 1}, 0, {0, 0}};

double fluxPerStepOf(const ExactBeams::Inputs& inputs) {
    const double beams = 2.0 * inputs.surface.quads.x * inputs.surface.quads.y;
    return fluxPerStep(inputs.map, inputs.light, inputs.patch, beams);
}

int sumsATexel(const ExactBeams::Inputs& inputs) {
    return channelsOf(inputs.colours, inputs.water, inputs.occluders && inputs.occluders->coloured());
}

bool mayBeShaded(const ExactBeams::Inputs& inputs) {
    return inputs.occluders || inputs.beams.surfaceShadow;
}

} // namespace

ExactBeams::ExactBeams(gl::Context& context, std::int64_t touches)
    : _context(context), _footprints(context), _sums(context), _resolve({"caustics/resolve_sums.comp"}),
      _lists(context), _mostTouches(touches) {}

const gl::Program& ExactBeams::program(Pass pass, const Variant& variant) {
    std::optional<gl::Program>& program =
        _programs[std::size_t(pass)][std::size_t(variant.extinction) + 2 * std::size_t(variant.coloured) +
                                     4 * std::size_t(variant.shaded) + 8 * std::size_t(variant.veiled) +
                                     16 * std::size_t(variant.broad)];
    if (program) return *program;
    std::vector<std::string> defines;
    if (variant.extinction) defines.emplace_back("EXTINCTION");
    if (variant.coloured) defines.emplace_back("COLOURED");
    if (variant.shaded) defines.emplace_back("SHADED");
    if (variant.veiled) defines.emplace_back("VEILS");
    if (variant.broad) defines.emplace_back("BROAD");
    constexpr const char* files[] = {"caustics/exact_beams.comp", "caustics/exact_beams_by_texel.comp",
                                     "caustics/exact_beams_gather.comp", "caustics/exact_beams_touches.comp"};
    return program.emplace(std::initializer_list<const char*>{files[int(pass)]}, defines);
}

/// Room for lists and touches, all empty.
void ExactBeams::prepareLists(const Inputs& inputs) {
    const glm::ivec2 size = inputs.map.frame.size, quads = inputs.surface.quads;
    _lists.clear(std::int64_t(quads.x) * quads.y, std::int64_t(size.x) * size.y);
    if (!mayBeShaded(inputs)) return;
    if (!_touches.id())
        _touches =
            gl::Buffer(_context.ledger(), "beam touches", std::int64_t(sizeof(noTouches)) + 8 * _mostTouches);
    _touches.write(0, sizeof(noTouches), &noTouches);
    _touches.bindStorage(beamTouchesBuffer);
}

void ExactBeams::bind(const Inputs& inputs) const {
    inputs.beams.frame.bindUniform(lightFrameBlock);
    inputs.map.box.bindUniform(boxFrameBlock);
    inputs.planes.planes.bind(tangentPlanesUnit);
    inputs.planes.depthPyramid.bind(depthPyramidUnit);
    inputs.beams.flux.bindStorage(beamFluxBuffer);
    _footprints.rays().bindStorage(footprintsBuffer);
    _footprints.originDepths().bindStorage(originDepthsBuffer);
    inputs.beams.lit.bindStorage(beamLitBuffer);
    _lists.bind();
    if (inputs.occluders) inputs.occluders->bind();
    if (inputs.beams.surfaceShadow) inputs.beams.surfaceShadow->bind(surfaceShadowUnit);
}

void ExactBeams::set(const gl::Program& program, const Inputs& inputs, const Variant& variant,
                     double stepsPerFlux) const {
    program.set(stepsPerFluxLocation, float(stepsPerFlux));
    if (variant.extinction)
        program.set(extinctionPerMetreLocation, glm::vec3(inputs.water.absorption + inputs.water.scattering));
    if (!variant.shaded) return;
    program.set(testOcclusionLocation, inputs.occluders ? 1 : 0);
    program.set(testSurfaceShadowLocation, inputs.beams.surfaceShadow ? 1 : 0);
}

/// Narrow and broad ones.
void ExactBeams::doListed(const Use& use, Pass pass, int list) const {
    _lists.dispatch(use(pass, false, false), list);
    _lists.dispatch(use(pass, false, true), list + gpu::broad);
}

/// Those in their list, then those that found no room there.
void ExactBeams::doTouches(const gl::Program& program) const {
    program.set(listLocation, gpu::shaded);
    program.dispatchIndirect(_touches, 0);
    program.set(listLocation, gpu::left);
    _lists.dispatch(program, gpu::left);
}

void ExactBeams::bindSums(const Inputs& inputs) {
    const glm::ivec2 size = inputs.map.frame.size;
    _sums.bind(std::int64_t(size.x) * size.y * sumsATexel(inputs));
}

void ExactBeams::deposit(const Inputs& inputs) {
    if (inputs.beams.strength == glm::dvec3(0)) return;
    bindSums(inputs);
    const double stepsPerFlux = 1 / (fluxPerStepOf(inputs) * inputs.points);
    const bool coloured = sumsATexel(inputs) > 1;
    const bool extinction = inputs.water.absorption + inputs.water.scattering != glm::dvec3(0);
    const bool shade = mayBeShaded(inputs);
    _footprints.updateRays(inputs.beams, inputs.surface, inputs.map, inputs.culling);
    prepareLists(inputs);
    bind(inputs);
    const Use use = [&](Pass pass, bool shaded, bool broad) -> const gl::Program& {
        const bool deposits = pass != Pass::Gather;
        // The pass over all quads only asks whether something may be in the way.
        const bool veiled = pass == Pass::Touches && inputs.occluders && inputs.occluders->veiled();
        const Variant variant{deposits && extinction, deposits && coloured, shaded, veiled, broad};
        const gl::Program& found = program(pass, variant);
        found.set(quadsLocation, inputs.surface.quads);
        if (deposits) set(found, inputs, variant, stepsPerFlux);
        if (shaded) found.set(receiverNumberLocation, inputs.receiverNumber);
        return found;
    };
    BeamCulling::dispatch(use(Pass::AllQuads, shade, false), inputs.culling, inputs.surface.quads);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
    if (shade) doListed(use, Pass::Gather, gpu::shaded);
    doListed(use, Pass::ByTexel, gpu::plain);
    if (shade) {
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
        doTouches(use(Pass::Touches, true, false));
    }
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT |
                    GL_BUFFER_UPDATE_BARRIER_BIT); // the next map empties the lists
}

void ExactBeams::resolve(CausticMap& caustics, const Inputs& inputs) {
    const glm::ivec2 size = inputs.map.frame.size;
    caustics.resize(_context, size);
    bindSums(inputs);
    inputs.map.box.bindUniform(boxFrameBlock);
    inputs.map.normal.bind(normalMapUnit);
    inputs.planes.planes.bind(tangentPlanesUnit);
    caustics.irradiance.bindImage(irradianceImage, GL_WRITE_ONLY);
    const double fluxPerStep = fluxPerStepOf(inputs);
    _resolve.set(wattsPerStepLocation,
                 glm::vec3(inputs.beams.strength * (fluxPerStep / inputs.map.frame.texelArea())));
    _resolve.set(channelsLocation, sumsATexel(inputs));
    _resolve.dispatch2D(size, resolveGroupSize);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

} // namespace limpid
