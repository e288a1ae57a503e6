#pragma once
#include "audit/FluxAudit.h"
#include "engine/Engine.h"
#include "engine/Readback.h"
#include "engine/Scenes.h"
#include "gl/GLFixture.h"

namespace limpid {

/// What a bake of a scene gives, map by map and light by light.
struct Baked {
    std::vector<MapData> maps;
    std::vector<int> planesDrawn, planesRequested;
    std::vector<TexelFrame> frames;
    std::vector<FluxBalance> flux;
};

class EngineGLTest : public GLTest {
  protected:
    static Baked bake(Engine& engine, const Scene& scene, bool audit = false) {
        engine.set(scene);
        engine.updateCaustics(0);
        Baked baked;
        for (const MapWork& maps : engine.maps()) {
            const gl::Texture coverage = engine.coverage(maps);
            baked.maps.push_back(readMaps(maps, engine.origin(), &coverage));
            baked.planesDrawn.push_back(int(maps.level.planes.size()));
            baked.planesRequested.push_back(maps.level.requestedPlanes);
            baked.frames.push_back(maps.level.frame);
        }
        if (audit) baked.flux = auditFlux(engine, baked.maps);
        return baked;
    }
    /// One for all tests of a program: each compiles its shaders for itself.
    static Engine& sharedEngine() {
        static Engine instance(context());
        return instance;
    }
    static Baked bake(const Scene& scene, bool audit = false) { return bake(sharedEngine(), scene, audit); }
    /// By an engine that has done nothing before.
    static Baked bakeAfresh(const Scene& scene, bool audit = false) {
        Engine fresh(context());
        return bake(fresh, scene, audit);
    }
};

} // namespace limpid
