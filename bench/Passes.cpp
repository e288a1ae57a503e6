#include "Bench.h"
#include "caustics/DrawnPlanes.h"
#include "caustics/ExactBeams.h"
#include "caustics/Volumetric.h"
#include "gl/Guard.h"

namespace limpid::bench {

namespace {

void addWater(Bench& bench) {
    for (const int quads : {200, 256, 512}) {
        const StageSize size{.quads = quads};
        bench.add("water_surface", size, [](Stage& s) {
            return [&s] { s.surface.update(s.scene.water, s.patch, glm::dvec3(0), 0); };
        });
        bench.add("beam_tracing", size,
                  [](Stage& s) { return [&s] { s.tracer.trace(s.beams, s.surface.mesh(), nullptr); }; });
    }
}

void addLevelMaps(Bench& bench) {
    for (const char* receiver : {"sphere", "teapot"})
        for (const int mapSize : {512, 1024})
            bench.add("level_map", {receiver, 32, mapSize},
                      [](Stage& s) { return [&s] { s.levelMapPass.draw(s.map, s.receiver()); }; });
    for (const int planes : {17, 101})
        bench.add("smart_slicing", {"teapot", 32, 512, planes}, [](Stage& s) {
            return [&s, slicing = SmartSlicing(s.context), kept = s.map.planes]() mutable {
                slicing.dropEmptyPlanes(s.map);
                s.map.planes = kept;
            };
        });
}

void addDrawnPlanes(Bench& bench) {
    for (const int planes : {1, 3, 17, 101})
        bench.add("drawn_planes", {"teapot", 256, 512, planes}, [](Stage& s) {
            return [&s, pass = DrawnPlanes(s.context), caustics = CausticMap()]() mutable {
                pass.fill(caustics, s.map, s.beams, s.surface.mesh(), s.scene.water);
            };
        });
}

/// With the tracing of the beams, as the yardsticks have it.
void addExactBeams(Bench& bench) {
    for (const StageSize& size :
         {StageSize{"floor", 256, 512}, {"floor", 200, 1024}, {"floor", 512, 1536}, {"teapot", 256, 512}})
        bench.add("exact_beam", size, [](Stage& s) {
            return [&s, pass = ExactBeams(s.context), caustics = CausticMap()]() mutable {
                s.tracer.trace(s.beams, s.surface.mesh(), nullptr);
                pass.fill(caustics, {s.map, 0, s.tangents, s.occluders(), s.beams, s.surface.mesh(), s.patch,
                                     s.scene.water, s.scene.lights[0]});
            };
        });
}

/// Slices, caustics and their combination.
void addVolumetric(Bench& bench) {
    for (const int planes : {3, 17})
        bench.add("volumetric", {"teapot", 256, 512, planes}, [](Stage& s) {
            return [&s, pass = Volumetric(s.context), slices = Slices(), caustics = CausticMap()]() mutable {
                pass.drawSlices(slices, s.map, s.receiver());
                pass.drawCaustics(slices, s.map, s.beams, s.surface.mesh(), s.scene.water);
                pass.combine(caustics, s.map, slices);
            };
        });
}

/// What a host pays once for each call (gl/Guard.h): its state out and in again, with nothing drawn between.
void addGuard() {
    benchmark::RegisterBenchmark("guard", [](benchmark::State& state) {
        gl::Context host(gl::Context::Current{}, {});
        for (auto _ : state)
            const gl::Guard guard(host);
    })->Unit(benchmark::kMicrosecond);
}

} // namespace

void addPasses(Bench& bench) {
    addGuard();
    addWater(bench);
    addLevelMaps(bench);
    addDrawnPlanes(bench);
    addExactBeams(bench);
    addVolumetric(bench);
}

} // namespace limpid::bench
