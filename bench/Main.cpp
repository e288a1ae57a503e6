#include <vector>

#include "Bench.h"

// Flags given by the user come later and win. Repetitions of all benchmarks in random order: drift of a busy
// machine hits all alike, so that ratios within one run can be trusted.
int main(int argc, char** argv) {
    std::string defaults[] = {"--benchmark_repetitions=5", "--benchmark_enable_random_interleaving=true",
                              "--benchmark_report_aggregates_only=true", "--benchmark_min_time=0.1"};
    std::vector<char*> arguments{argv[0]};
    for (std::string& flag : defaults)
        arguments.push_back(flag.data());
    arguments.insert(arguments.end(), argv + 1, argv + argc);
    int count = int(arguments.size());
    benchmark::Initialize(&count, arguments.data());
    if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;
    try {
        limpid::gl::Context context;
        benchmark::AddCustomContext("limpid", LIMPID_VERSION);
        benchmark::AddCustomContext("gpu", context.info().renderer);
        limpid::bench::Bench bench(context);
        limpid::bench::addPasses(bench);
        limpid::bench::addChanges(context);
        limpid::bench::addYardsticks(bench);
        benchmark::RunSpecifiedBenchmarks();
        benchmark::Shutdown();
    } catch (const std::exception& error) {
        fmt::print(stderr, "limpid-bench: {}\n", error.what());
        return 3;
    }
    return 0;
}
