// limpid-soak [FRAMES]: memory after every hundredth frame as CSV; exit code 1 if it grew. See tools/soak.
#include "stress/Soak.h"

#include <algorithm>
#include <cstdlib>
#include <span>
#include <vector>

#include "core/Error.h"

namespace {

using limpid::soak::Sample;

std::int64_t median(std::span<const Sample> samples, std::int64_t Sample::*kind) {
    std::vector<std::int64_t> values;
    for (const Sample& sample : samples)
        values.push_back(sample.*kind);
    std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(values.size() / 2), values.end());
    return values[values.size() / 2];
}

/// Of each kind over a part of the run. The driver frees what it holds when it sees fit, some 50 MiB at a
/// time, so that the largest tells nothing.
Sample medians(std::span<const Sample> samples) {
    return {samples.back().frame, median(samples, &Sample::gpuBytes), median(samples, &Sample::heapBytes),
            median(samples, &Sample::memoryBytes)};
}

} // namespace

int main(int argc, char** argv) {
    using namespace limpid;
    const int frames = argc > 1 ? std::atoi(argv[1]) : 10000;
    std::vector<soak::Sample> samples;
    try {
        gl::Context context;
        std::printf("frame,gpu_bytes,heap_bytes,resident_bytes\n");
        soak::run(context, frames, std::max(frames / 100, 1), [&](const soak::Sample& sample) {
            samples.push_back(sample);
            std::printf("%d,%lld,%lld,%lld\n", sample.frame, static_cast<long long>(sample.gpuBytes),
                        static_cast<long long>(sample.heapBytes), static_cast<long long>(sample.memoryBytes));
            std::fflush(stdout);
        });
    } catch (const GraphicsError& error) {
        std::fprintf(stderr, "limpid-soak: %s\n", error.what());
        return 3;
    }
    // The first fifth warms up: the driver compiles what it meets, and passes are made as methods come.
    const std::size_t count = samples.size();
    const std::span<const Sample> all(samples);
    const Sample early = medians(all.subspan(count / 5, count * 2 / 5)),
                 late = medians(all.subspan(count * 3 / 5));
    std::fprintf(stderr, "GPU %lld -> %lld bytes, heap %.1f -> %.1f MiB, resident %.1f -> %.1f MiB\n",
                 static_cast<long long>(early.gpuBytes), static_cast<long long>(late.gpuBytes),
                 double(early.heapBytes) / (1 << 20), double(late.heapBytes) / (1 << 20),
                 double(early.memoryBytes) / (1 << 20), double(late.memoryBytes) / (1 << 20));
    // What the driver compiles late is within 2 %.
    const auto grew = [](std::int64_t from, std::int64_t to) { return to > from + from / 50; };
    return late.gpuBytes > early.gpuBytes || grew(early.heapBytes, late.heapBytes) ||
           grew(early.memoryBytes, late.memoryBytes);
}
