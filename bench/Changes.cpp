#include "Bench.h"

#include "engine/Engine.h"
#include "io/toml/SceneFile.h"
#include "scene/Shapes.h"

/// Cost of one change of a scene, up to new caustic maps, beside that of moving time.
namespace limpid::bench {

namespace {

Scene teapot() {
    return io::loadScene(LIMPID_ROOT "/models/teapot.glb");
}
Scene fish() {
    return io::loadScene(LIMPID_ROOT "/models/fish.glb");
}

/// Fifteen balls in rows over a floor, under waves.
Scene balls() {
    Scene scene;
    const auto ball = std::make_shared<const Mesh>(makeSphere(0.12, glm::vec3(0.8f)));
    scene.receivers.resize(16);
    scene.receivers[0].mesh = std::make_shared<const Mesh>(makePlane({2, 2}, glm::vec3(0.8f)));
    scene.receivers[0].translation.y = -1;
    for (int i = 0; i < 15; ++i) {
        scene.receivers[std::size_t(i) + 1].mesh = ball;
        scene.receivers[std::size_t(i) + 1].translation = {0.4 * (i % 5 - 2), -0.6, 0.5 * (i / 5 - 1)};
    }
    scene.lights = {Light()};
    scene.water.waves = {Wave()};
    return scene;
}

/// A scene that an engine has, and how often it was changed.
struct Live {
    Live(gl::Context& context, const Scene& start) : engine(context), scene(start) {}
    Engine engine;
    Scene scene;
    double time = 0;
    int count = 0;
    bool odd() { return ++count % 2 == 1; }
};

/// Registers a benchmark of `change(Live&)` and the update after it.
template <typename Change>
void add(gl::Context& context, const char* scene, Scene (*load)(), const char* name, Change change) {
    const auto body = [&context, load, change](benchmark::State& state) {
        Live live(context, load());
        const auto run = [&] {
            live.engine.set(live.scene);
            live.engine.updateCaustics(live.time);
            glFinish();
        };
        for (int i = 0; i < 3; ++i) // both ways once, and what only the first update makes
            run(), change(live);
        run();
        for (auto _ : state) {
            change(live);
            const auto start = std::chrono::steady_clock::now();
            run();
            state.SetIterationTime(
                std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        }
    };
    benchmark::RegisterBenchmark(fmt::format("change/{}/{}", scene, name).c_str(), body)
        ->UseManualTime()
        ->MeasureProcessCPUTime()
        ->Unit(benchmark::kMillisecond);
}

/// Registers a benchmark of the calling thread's work when the one receiver of a model moves, before any map.
void addMove(gl::Context& context, const char* model) {
    const auto body = [&context, model](benchmark::State& state) {
        Live live(context, io::loadScene(fmt::format(LIMPID_ROOT "/models/{}.glb", model)));
        live.engine.set(live.scene);
        for (auto _ : state) {
            live.scene.receivers[0].translation.x += live.odd() ? 0.02 : -0.02;
            live.engine.set(live.scene);
        }
    };
    benchmark::RegisterBenchmark(fmt::format("change/{}/move", model).c_str(), body)
        ->Unit(benchmark::kMillisecond);
}

} // namespace

void addChanges(gl::Context& context) {
    for (const char* model : {"teapot", "helicopter"})
        addMove(context, model);
    const std::pair<const char*, Scene (*)()> models[] = {{"teapot", teapot}, {"fish", fish}};
    for (const auto& [name, load] : models) {
        add(context, name, load, "time", [](Live& live) { live.time += 1.0 / 30; });
        add(context, name, load, "same_scene", [](Live&) {});
        add(context, name, load, "amplitude",
            [](Live& live) { live.scene.water.waves[0].amplitude *= live.odd() ? 1.25 : 0.8; });
        add(context, name, load, "light_colour", [](Live& live) {
            live.scene.lights[0].irradiance = live.odd() ? glm::dvec3(3, 2, 1) : glm::dvec3(1, 2, 3);
        });
        add(context, name, load, "light_intensity",
            [](Live& live) { live.scene.lights[0].irradiance *= live.odd() ? 2 : 0.5; });
    }
    add(context, "balls", balls, "all_anew", [](Live& live) { live.engine.setReuse(false); });
    add(context, "balls", balls, "time", [](Live& live) {
        live.time += 1.0 / 30;
        live.scene.water.waves[0].speed = 0.1;
    });
    add(context, "balls", balls, "one_moved",
        [](Live& live) { live.scene.receivers[8].translation.x = live.odd() ? 0.02 : 0; });
}

} // namespace limpid::bench
