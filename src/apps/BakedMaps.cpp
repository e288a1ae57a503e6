#include "apps/BakedMaps.h"

#include "engine/Readback.h"

namespace limpid::apps {

namespace {

io::BakedMap bakedMap(Engine& engine, const ReceiverMaps& maps) {
    const gl::Texture coverage = engine.coverage(maps);
    MapData data = readMaps(maps, engine.origin(), &coverage);
    io::BakedMap baked;
    baked.receiver = engine.scene().receivers[std::size_t(maps.receiver)].name;
    baked.light = engine.scene().lights[std::size_t(maps.light)].name;
    baked.size = data.size;
    baked.irradiance = std::move(data.irradiance);
    baked.position = std::move(data.position);
    baked.normal = std::move(data.normal);
    TexelFrame frame = maps.level.frame;
    frame.box.corner -= engine.origin();
    baked.worldToTexture = frame.worldToTexture();
    baked.facing = maps.level.facing;
    baked.planesRequested = maps.level.requestedPlanes;
    baked.planesDrawn = int(maps.level.planes.size());
    baked.deposited = data.deposited;
    return baked;
}

} // namespace

std::vector<io::BakedMap> bakedMaps(Engine& engine) {
    std::vector<io::BakedMap> baked;
    for (const ReceiverMaps& maps : engine.maps())
        baked.push_back(bakedMap(engine, maps));
    return baked;
}

} // namespace limpid::apps
