#include <fmt/format.h>

#include "apps/BakedMaps.h"
#include "apps/Common.h"
#include "engine/Engine.h"
#include "io/BakedFolder.h"

namespace limpid::apps {

namespace {

struct BakeOptions {
    CommonOptions common;
    std::string output;
    double time = 0;
};

io::BakedLight bakedLight(Engine& engine, int index, const std::vector<io::BakedMap>& maps) {
    FluxBalance flux = engine.auditFlux(index);
    const std::string& name = engine.scene().lights[std::size_t(index)].name;
    for (const io::BakedMap& map : maps)
        if (map.light == name) flux.deposited += map.deposited;
    const int beams = engine.light(index).mapBeams().triangleCount;
    return {name,          beams,          engine.beamsDrawn(index), flux.entering,
            flux.absorbed, flux.scattered, flux.deposited,           flux.missed,
            flux.rejected, flux.residual()};
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
    engine.setScene(std::move(scene));
    printWarnings(engine, options.common);
    engine.updateCaustics(options.time);
    io::Bake result;
    result.device = context.info().renderer;
    result.input = options.common.input;
    result.method = methodName(engine.scene().caustics.method);
    result.time = options.time;
    result.origin = engine.origin();
    result.maps = bakedMaps(engine);
    for (int light = 0; light < int(engine.scene().lights.size()); ++light)
        result.lights.push_back(bakedLight(engine, light, result.maps));
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
    command->callback([options] { bake(*options); });
}

} // namespace limpid::apps
