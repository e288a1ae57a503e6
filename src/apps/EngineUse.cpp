#include "apps/EngineUse.h"

#include <fmt/format.h>

#include "plan/Warnings.h"

namespace limpid::apps {

gl::ContextOptions contextOptions(const CommonOptions& options) {
    gl::ContextOptions context;
    context.device = options.device;
    context.memory = std::int64_t(options.gpuMemory * (1 << 20));
#ifndef NDEBUG
    context.debug = true;
#endif
    return context;
}

void printWarnings(const Engine& engine, const CommonOptions& options) {
    if (options.quiet) return;
    for (const std::string& warning : sceneWarnings(engine.scene(), engine.waterPatch()))
        fmt::print(stderr, "limpid: warning: {}\n", warning);
}

void printWork(Engine& engine, gl::Context& context, std::FILE* out) {
    fmt::print(out, "GPU: {}\n", context.info().renderer);
    for (const auto& [pass, ms] : engine.timers().collect())
        fmt::print(out, "  {:<18} {:10.2f} ms\n", pass, ms);
    for (const MapWork& maps : engine.maps())
        fmt::print(out, "  {} in {}: {} of {} planes\n",
                   engine.scene().receivers[std::size_t(maps.plan.receiver)].name,
                   engine.scene().lights[std::size_t(maps.plan.light)].name, maps.level.planes.size(),
                   maps.level.requestedPlanes);
    for (const auto& [kind, count] : engine.skipped().byKind())
        fmt::print(out, "  {:<22} {:6} skipped\n", kind, count);
    for (const auto& [kind, bytes] : context.ledger().byKind())
        fmt::print(out, "  {:<18} {:10.2f} MiB\n", kind, double(bytes) / (1 << 20));
    fmt::print(out, "  {:<18} {:10.2f} MiB, at most {:.2f} MiB\n", "total",
               double(context.ledger().total()) / (1 << 20), double(context.ledger().peak()) / (1 << 20));
}

} // namespace limpid::apps
