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
    TestOcclusion,
    TestSurfaceShadow,
    ReceiverNumber,
    ListNumber
};
enum ResolveUniform { WattsPerStep, Channels };
constexpr int groupSize = 64;
constexpr glm::ivec2 resolveGroupSize{8, 8};

/// Touches of quads that may be shaded, which wait for their pass: 16 MiB of them. Quads beyond are walked as
/// wide ones are.
constexpr std::int64_t mostTouches = 1 << 21;

/// As shaders/interface/beam_lists.glsl has them.
enum List { Plain, ShadedQuads, Wide };
struct ListWork {
    std::uint32_t groups[3]{0, 1, 1};
    std::uint32_t count = 0;
};

/// As shaders/interface/beam_touches.glsl has it.
struct TouchWork {
    std::uint32_t groups[3]{0, 1, 1};
    std::int32_t asked = 0, count[2]{};
};

double fluxPerStepOf(const ExactBeams::Inputs& inputs) {
    const double beams = 2.0 * inputs.surface.quads.x * inputs.surface.quads.y;
    return fluxPerStep(inputs.map, inputs.light, inputs.patch, beams);
}

int sumsATexel(const ExactBeams::Inputs& inputs) {
    return channelsOf(inputs.colours, inputs.water, inputs.occluders && inputs.occluders->coloured());
}

} // namespace

ExactBeams::ExactBeams(gl::Context& context)
    : _context(context), _footprints(context), _sums(context), _resolve({"caustics/resolve_sums.comp"}),
      _largeBeams(context) {}

const gl::Program& ExactBeams::program(Pass pass, const Variant& variant) {
    std::optional<gl::Program>& program =
        _programs[std::size_t(pass)][std::size_t(variant.extinction) + 2 * std::size_t(variant.coloured) +
                                     4 * std::size_t(variant.shaded) + 8 * std::size_t(variant.veiled)];
    if (program) return *program;
    std::vector<std::string> defines;
    if (variant.extinction) defines.emplace_back("EXTINCTION");
    if (variant.coloured) defines.emplace_back("COLOURED");
    if (variant.shaded) defines.emplace_back("SHADED");
    if (variant.veiled) defines.emplace_back("VEILS");
    if (pass == Pass::Tiles) defines.emplace_back("LARGE");
    constexpr const char* files[] = {"caustics/exact_beams.comp", "caustics/exact_beams_by_texel.comp",
                                     "caustics/exact_beams_gather.comp", "caustics/exact_beams_touches.comp",
                                     "caustics/exact_beams_by_texel.comp"};
    return program.emplace(std::initializer_list<const char*>{files[int(pass)]}, defines);
}

/// Room for the lists and tiles, both empty.
void ExactBeams::prepareLists(std::int64_t quads) {
    gl::Ledger& ledger = _context.ledger();
    constexpr ListWork none[3];
    const std::int64_t bytes = std::int64_t(sizeof(none)) + 3 * 4 * quads;
    if (_lists.bytes() != bytes) _lists = gl::Buffer(ledger, "beam lists", bytes);
    _lists.write(0, sizeof(none), none);
    _largeBeams.clear();
}

void ExactBeams::bind(const Inputs& inputs) const {
    inputs.beams.frame.bindUniform(0);
    inputs.map.box.bindUniform(1);
    inputs.planes.planes.bind(0);
    inputs.planes.depthPyramid.bind(2);
    inputs.beams.flux.bindStorage(5);
    _footprints.rays().bindStorage(6);
    _footprints.originDepths().bindStorage(7);
    _lists.bindStorage(10);
    if (inputs.occluders) inputs.occluders->bind();
    if (inputs.beams.surfaceShadow) inputs.beams.surfaceShadow->bind(surfaceShadowUnit);
}

void ExactBeams::set(const gl::Program& program, const Inputs& inputs, const Variant& variant,
                     double stepsPerFlux) const {
    program.set(StepsPerFlux, float(stepsPerFlux));
    if (variant.extinction)
        program.set(ExtinctionPerMetre, glm::vec3(inputs.water.absorption + inputs.water.scattering));
    if (!variant.shaded) return;
    program.set(TestOcclusion, inputs.occluders ? 1 : 0);
    program.set(TestSurfaceShadow, inputs.beams.surfaceShadow ? 1 : 0);
}

void ExactBeams::byTexel(const gl::Program& program, int list) const {
    program.set(ListNumber, list);
    program.dispatchIndirect(_lists, std::int64_t(list) * std::int64_t(sizeof(ListWork)));
}

/// Quads that may be shaded, touch by touch.
void ExactBeams::depositShaded(const Use& use) {
    if (!_touches.id())
        _touches =
            gl::Buffer(_context.ledger(), "beam touches", std::int64_t(sizeof(TouchWork)) + 8 * mostTouches);
    constexpr TouchWork none;
    _touches.write(0, sizeof(none), &none);
    _touches.bindStorage(11);
    use(Pass::Gather, false).dispatchIndirect(_lists, ShadedQuads * std::int64_t(sizeof(ListWork)));
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
    use(Pass::Touches, true).dispatchIndirect(_touches, 0);
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
    const bool mayBeShaded = inputs.occluders || inputs.beams.surfaceShadow;
    const std::int64_t quads = std::int64_t(inputs.surface.quads.x) * inputs.surface.quads.y;
    _footprints.updateRays(inputs.beams, inputs.surface, inputs.map, inputs.culling);
    prepareLists(quads);
    bind(inputs);
    const Use use = [&](Pass pass, bool shaded) -> const gl::Program& {
        const bool deposits = pass != Pass::Gather;
        // The pass over all quads only asks whether something may be in the way.
        const bool veiled = pass != Pass::AllQuads && deposits && shaded && inputs.occluders &&
                            inputs.occluders->veiled();
        const Variant variant{deposits && extinction, deposits && coloured, shaded, veiled};
        const gl::Program& found = program(pass, variant);
        found.set(Quads, inputs.surface.quads);
        if (deposits) set(found, inputs, variant, stepsPerFlux);
        if (deposits && shaded) found.set(ReceiverNumber, inputs.receiverNumber);
        return found;
    };
    inputs.beams.lit.bindStorage(9);
    BeamCulling::dispatch(use(Pass::AllQuads, mayBeShaded), inputs.culling, inputs.surface.quads);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);

    _largeBeams.bind();
    if (mayBeShaded) depositShaded(use);
    byTexel(use(Pass::Listed, false), Plain);
    if (mayBeShaded) byTexel(use(Pass::Listed, true), Wide);
    _largeBeams.dispatch(use(Pass::Tiles, mayBeShaded));
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void ExactBeams::resolve(CausticMap& caustics, const Inputs& inputs) {
    const glm::ivec2 size = inputs.map.frame.size;
    caustics.resize(_context, size);
    bindSums(inputs);
    inputs.map.box.bindUniform(1);
    inputs.map.normal.bind(0);
    inputs.planes.planes.bind(1);
    caustics.irradiance.bindImage(0, GL_WRITE_ONLY);
    const double fluxPerStep = fluxPerStepOf(inputs);
    _resolve.set(WattsPerStep,
                 glm::vec3(inputs.beams.strength * (fluxPerStep / inputs.map.frame.texelArea())));
    _resolve.set(Channels, sumsATexel(inputs));
    _resolve.dispatch2D(size, resolveGroupSize);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

} // namespace limpid
