#include <fmt/format.h>

#include "apps/BakedMaps.h"
#include "apps/Common.h"
#include "apps/EngineUse.h"
#include "engine/Engine.h"
#include "io/bake/BakedFolder.h"
#ifdef LIMPID_WITH_REFERENCE
#include "audit/FluxAudit.h"
#endif

namespace limpid::apps {

namespace {

struct BakeOptions {
    CommonOptions common;
    std::string output;
    double time = 0;
    bool noAudit = false;
};

#ifdef LIMPID_WITH_REFERENCE
/// Where each light went, in the order of the scene's lights.
std::vector<io::BakedFlux> countFlux(const Engine& engine, const std::vector<MapData>& maps) {
    std::vector<io::BakedFlux> counted;
    for (const FluxBalance& flux : auditFlux(engine, maps))
        counted.push_back({flux.entering, flux.absorbed, flux.scattered, flux.deposited, flux.missed,
                           flux.rejected, flux.residual(), flux.standardError});
    return counted;
}
#else
/// This build has no ray tracer.
std::vector<io::BakedFlux> countFlux(const Engine&, const std::vector<MapData>&) {
    return {};
}
#endif

/// `flux`: of each light, or empty.
std::vector<io::BakedLight> bakedLights(const Engine& engine, const std::vector<io::BakedFlux>& flux) {
    std::vector<io::BakedLight> baked;
    for (std::size_t i = 0; i < engine.scene().lights.size(); ++i) {
        baked.push_back({engine.scene().lights[i].name,
                         engine.light(int(i)).mapBeams().triangleCount,
                         engine.beamsDrawn(int(i)),
                         {}});
        if (!flux.empty()) baked.back().flux = flux[i];
    }
    return baked;
}

void printBake(const io::Bake& bake) {
    for (const io::BakedMap& map : bake.maps)
        fmt::print("{} in {}: {} x {} texels, {} of {} planes, {:.6g} W\n", map.receiver, map.light,
                   map.size.x, map.size.y, map.planesDrawn, map.planesRequested, map.deposited);
    printFlux(bake);
}

void bake(const BakeOptions& options) {
    requireTime(options.time);
    Scene scene = loadScene(options.common);
    io::prepareFolder(options.output);
    gl::Context context(contextOptions(options.common));
    Engine engine(context);
    engine.setSkipping(!options.common.noSkip);
    engine.set(std::move(scene));
    printWarnings(engine, options.common);
    engine.updateCaustics(options.time);
    io::Bake result;
    result.device = context.info().renderer;
    result.input = options.common.input;
    result.method = methodName(engine.scene().caustics.method);
    result.time = options.time;
    result.origin = engine.origin();
    std::vector<MapData> maps = readAllMaps(engine);
    const auto flux = options.noAudit ? std::vector<io::BakedFlux>() : countFlux(engine, maps);
    result.lights = bakedLights(engine, flux);
    result.maps = bakedMaps(engine, std::move(maps));
    io::writeBake(options.output, result);
    if (!options.common.quiet) printBake(result);
    if (options.common.verbose) printWork(engine, context);
}

} // namespace

void addBake(CLI::App& app) {
    auto* command = app.add_subcommand("bake", "caustic maps as data: index.json and OpenEXR files");
    command->footer("Examples:\n  limpid bake scene.toml -o maps --method level-map --planes 50");
    auto options = std::make_shared<BakeOptions>();
    addCommonOptions(*command, options->common);
    command->add_option("-o,--output", options->output, "folder to write to")->required();
    command->add_option("--time", options->time, "seconds");
    command->add_flag("--no-audit", options->noAudit, "do not count where the light went");
    command->callback([options] { bake(*options); });
}

} // namespace limpid::apps
