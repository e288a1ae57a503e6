#pragma once
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <functional>
#include <random>

#include <malloc.h>
#include <unistd.h>

#include "engine/Engine.h"
#include "engine/Scenes.h"

/// Many small frames in one engine, with receivers, lights, waves and methods that come and go.
namespace limpid::soak {

struct Sample {
    int frame = 0;
    std::int64_t gpuBytes = 0;    ///< as the ledger has them, with the same scene each time
    std::int64_t heapBytes = 0;   ///< of the process, as asked for from malloc, the driver's own among them
    std::int64_t memoryBytes = 0; ///< of the process, resident
};

inline std::int64_t residentBytes() {
    std::int64_t pages = 0, resident = 0;
    std::ifstream("/proc/self/statm") >> pages >> resident;
    return resident * sysconf(_SC_PAGESIZE);
}

inline std::int64_t heapBytes() {
    const struct mallinfo2 info = mallinfo2();
    return std::int64_t(info.uordblks) + std::int64_t(info.hblkhd);
}

/// Of a few kinds of each thing, so that scenes differ in number, order and size.
inline Scene anyScene(std::mt19937& random) {
    const auto upTo = [&](int most) { return int(random() % std::uint32_t(most + 1)); };
    const auto number = [&](double from, double to) {
        return from + (to - from) * double(random()) / 4294967296.0;
    };
    Scene scene;
    for (int i = upTo(5); i > 0; --i) {
        const glm::dvec3 at(number(-0.6, 0.6), number(-1, 0.1), number(-0.6, 0.6));
        const double size = number(0.1, 0.5);
        const int kind = upTo(2);
        scene.receivers.push_back(scenes::shape("r",
                                                kind == 0   ? makePlane(glm::dvec2(size), {})
                                                : kind == 1 ? makeBox(glm::dvec3(size), {})
                                                            : makeSphere(size, {}),
                                                at));
        scene.receivers.back().name += std::to_string(i);
    }
    for (int i = upTo(3); i > 0; --i) {
        scene.lights.push_back(scenes::sunAt(number(0, 80)));
        scene.lights.back().name += std::to_string(i);
        if (upTo(2) == 0) scene.lights.back().type = LightType::Point;
        scene.lights.back().position = {number(-1, 1), number(-0.5, 1), number(-1, 1)};
    }
    if (upTo(1)) scene.water.waves.push_back(scenes::cosine(0.01, number(0.3, 1), {1, number(-1, 1)}));
    if (upTo(1)) scene.water.waves.push_back(scenes::noise(0.01, number(0.3, 1)));
    scene.water.grid = glm::ivec2(4 << upTo(2));
    scene.caustics.mapSize = 8 << upTo(2);
    scene.caustics.planes = 1 + upTo(4);
    scene.caustics.photonGrid = {8, 8}; // the paper's 200² a receiver would take most of the time
    scene.caustics.method = allMethods()[random() % allMethods().size()];
    return scene;
}

/// A frame of a scene, which is never the one before; every `period`th is the same one.
inline void run(gl::Context& context, int frames, int period,
                const std::function<void(const Sample&)>& report) {
    std::mt19937 random(1), fixed(5);
    const Scene same = anyScene(fixed);
    Engine engine(context);
    for (int frame = 0; frame <= frames; ++frame) {
        const bool measured = frame % period == 0;
        engine.set(measured ? same : anyScene(random));
        engine.updateCaustics(0.1 * frame);
        engine.draw({16, 9});
        if (measured) report({frame, context.ledger().total(), heapBytes(), residentBytes()});
    }
}

} // namespace limpid::soak
