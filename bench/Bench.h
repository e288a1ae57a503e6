#pragma once
#include <algorithm>
#include <chrono>
#include <exception>
#include <map>
#include <memory>
#include <vector>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "Stage.h"
#include "gl/Api.h"

namespace limpid::bench {

/// Registers benchmarks of GPU passes. Each iteration is timed by the wall clock and waited for; "CPU" is
/// that of the whole process, which on a software driver is the work itself and hardly depends on what else
/// runs.
class Bench {
  public:
    explicit Bench(gl::Context& context) : _context(context) {}

    /// `prepare(Stage&)` makes what the pass needs and returns the pass: what is called once to warm up and
    /// then timed. It may throw, which shows as the benchmark's error.
    template <typename Prepare>
    void add(const std::string& pass, const StageSize& size, Prepare prepare) {
        const std::string name = fmt::format("{}/{}/beams:{}/map:{}/planes:{}", pass, size.receiver,
                                             size.beams(), size.mapSize, size.planes);
        const auto body = [this, size, prepare](benchmark::State& state) {
            try {
                auto run = prepare(stage(size));
                run();
                time(state, run);
            } catch (const std::exception& error) {
                state.SkipWithError(error.what());
            }
        };
        benchmark::RegisterBenchmark(name.c_str(), body)
            ->UseManualTime()
            ->MeasureProcessCPUTime()
            ->ComputeStatistics("min", smallest)
            ->Unit(benchmark::kMillisecond);
    }

  private:
    /// What else runs on the machine only ever adds time.
    static double smallest(const std::vector<double>& times) {
        return *std::min_element(times.begin(), times.end());
    }

    template <typename Run>
    static void time(benchmark::State& state, Run& run) {
        using Clock = std::chrono::steady_clock;
        glFinish();
        for (auto _ : state) {
            const auto start = Clock::now();
            run();
            glFinish();
            state.SetIterationTime(std::chrono::duration<double>(Clock::now() - start).count());
        }
    }

    Stage& stage(const StageSize& size) {
        std::unique_ptr<Stage>& kept = _stages[size];
        if (!kept) kept = std::make_unique<Stage>(_context, size);
        return *kept;
    }

    gl::Context& _context;
    std::map<StageSize, std::unique_ptr<Stage>> _stages;
};

/// The engine's own passes.
void addPasses(Bench& bench);
/// Cost of one change of a scene.
void addChanges(gl::Context& context);
/// What others do, and what no method can go below (see Yardsticks.cpp).
void addYardsticks(Bench& bench);

} // namespace limpid::bench
