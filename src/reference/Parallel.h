#pragma once
#include <algorithm>
#include <atomic>
#include <functional>
#include <thread>
#include <vector>

namespace limpid::reference {

/// What a number of threads asked for stands for: all of the machine's for 0.
inline int threadsOf(int asked) {
    return asked > 0 ? asked : std::max(int(std::thread::hardware_concurrency()), 1);
}

/// Calls `work(thread, i)` for every i in [0, count), on `threads` threads, one of them the caller's.
/// `between` is called by the caller's after each piece of its own, with the number of pieces begun.
inline void inParallel(int count, int threads, const std::function<void(int thread, int i)>& work,
                       const std::function<void(int begun)>& between = {}) {
    std::atomic<int> next = 0;
    const auto run = [&](int thread) {
        for (int i = next++; i < count; i = next++) {
            work(thread, i);
            if (thread == 0 && between) between(std::min(next.load(), count));
        }
    };
    std::vector<std::jthread> others;
    for (int thread = 1; thread < threads; ++thread)
        others.emplace_back(run, thread);
    run(0);
}

} // namespace limpid::reference
