#include "reference/Reference.h"

#include <fmt/format.h>

#include "apps/Common.h"
#include "io/bake/BakedFolder.h"
#include "plan/Warnings.h"
#include "reference/ReferenceJob.h"

namespace limpid::apps {

namespace {

struct ReferenceOptions {
    CommonOptions common;
    std::string output;
    double time = 0;
    std::int64_t photons = 100'000'000;
    std::uint64_t seed = 1;
    int threads = 0;
};

void printWarnings(const Scene& scene, const WaterPatch& patch) {
    // Not the ones about what only the GPU's methods leave out.
    Scene followed = scene;
    for (Light& light : followed.lights)
        light.angularDiameter = 0;
    WaterPatch fine = patch;
    fine.grid = glm::ivec2(1 << 20);
    for (const std::string& warning : sceneWarnings(followed, fine))
        fmt::print(stderr, "limpid: warning: {}\n", warning);
}

void printResult(const io::Bake& bake) {
    for (const io::BakedMap& map : bake.maps)
        fmt::print("{} in {}{}: {} x {} texels, {:.6g} W, standard error {:.3f} %\n", map.receiver, map.light,
                   map.facing > 0 ? fmt::format(", facing {}", map.facing) : "", map.size.x, map.size.y,
                   map.deposited, 100 * map.standardError.value_or(0));
    printFlux(bake);
}

void runReference(const ReferenceOptions& options) {
    requireTime(options.time);
    const Scene scene = loadScene(options.common);
    io::prepareFolder(options.output);
    const reference::TraceJob job = reference::referenceJob(scene, options.time);
    if (!options.common.quiet) printWarnings(scene, coveringPatch(scene));
    const reference::TraceOptions how{options.photons, options.seed, options.threads, {}};
    io::Bake bake = reference::traceBake(job, how, "light traced, percent", options.common.quiet);
    bake.input = options.common.input;
    io::writeBake(options.output, bake);
    if (!options.common.quiet) printResult(bake);
}

} // namespace

void addReference(CLI::App& app) {
    auto* command = app.add_subcommand("reference", "ground truth by light tracing, in the layout of bake");
    command->footer("Examples:\n  limpid reference scene.toml -o truth --photons 20000000");
    auto options = std::make_shared<ReferenceOptions>();
    addCommonOptions(*command, options->common);
    command->add_option("-o,--output", options->output, "folder to write to")->required();
    command->add_option("--time", options->time, "seconds");
    command
        ->add_option("--photons", options->photons,
                     "cells of the surface that are followed, for each light; more where they straddle edges")
        ->check(CLI::Range(std::int64_t(1), std::int64_t(100'000'000'000)))
        ->capture_default_str();
    command->add_option("--seed", options->seed, "another one, another error")->capture_default_str();
    command->add_option("--threads", options->threads, "0: all; the result is the same")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    command->callback([options] { runReference(*options); });
}

} // namespace limpid::apps
