#include "reference/Reference.h"

#include <embree3/rtcore_config.h>
#include <fmt/format.h>

#include "apps/Common.h"
#include "apps/ReferenceJob.h"
#include "core/Progress.h"
#include "engine/Warnings.h"
#include "io/BakedFolder.h"

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

reference::TraceResult trace(const reference::TraceJob& job, const ReferenceOptions& options) {
    constexpr int steps = 100;
    Progress progress("light traced, percent", steps, !options.common.quiet);
    int shown = 0;
    reference::TraceOptions how{options.photons, options.seed, options.threads, {}};
    how.progress = [&](int done, int total) {
        const int step = int(std::int64_t(steps) * done / total);
        if (step > shown) progress.update(step);
        shown = step;
    };
    return reference::traceLight(job, how);
}

io::Bake bakeOf(const reference::TraceJob& job, reference::TraceResult result) {
    io::Bake bake;
    bake.origin = job.origin;
    bake.time = job.time;
    bake.method = "reference";
    bake.device = fmt::format("CPU, Embree {}", RTC_VERSION_STRING);
    for (std::size_t i = 0; i < job.maps.size(); ++i) {
        const reference::MapRequest& request = job.maps[i];
        reference::TexelMap::Finished& finished = result.maps[i];
        io::BakedMap& map = bake.maps.emplace_back();
        map.receiver = job.scene.receivers[std::size_t(request.receiver)].name;
        map.light = job.scene.lights[std::size_t(request.light)].name;
        map.size = request.frame.size;
        map.facing = request.facing;
        map.irradiance = std::move(finished.irradiance);
        map.position = std::move(finished.position);
        map.normal = std::move(finished.normal);
        TexelFrame frame = request.frame;
        frame.box.corner -= job.origin;
        map.worldToTexture = frame.worldToTexture();
        map.deposited = finished.deposited;
        map.standardError = finished.standardError;
    }
    for (std::size_t i = 0; i < result.lights.size(); ++i) {
        const reference::TracedLight& light = result.lights[i];
        bake.lights.push_back({job.scene.lights[i].name, light.photons, light.photons, light.entering,
                               light.absorbed, light.scattered, light.deposited, light.missed, light.rejected,
                               light.residual()});
    }
    return bake;
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
    const reference::TraceJob job = referenceJob(scene, options.time);
    if (!options.common.quiet) printWarnings(scene, coveringPatch(scene));
    io::Bake bake = bakeOf(job, trace(job, options));
    bake.input = options.common.input;
    io::writeBake(options.output, bake);
    if (!options.common.quiet) printResult(bake);
}

} // namespace

void addReference(CLI::App& app) {
    auto* command = app.add_subcommand("reference", "ground truth by light tracing, in the layout of bake");
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
