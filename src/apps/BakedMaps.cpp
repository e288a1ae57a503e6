#include "apps/BakedMaps.h"

namespace limpid::apps {

namespace {

io::BakedMap bakedMap(const Engine& engine, const MapWork& maps, MapData data) {
    io::BakedMap baked;
    baked.receiver = engine.scene().receivers[std::size_t(maps.plan.receiver)].name;
    baked.light = engine.scene().lights[std::size_t(maps.plan.light)].name;
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

std::vector<MapData> readAllMaps(Engine& engine) {
    std::vector<MapData> read;
    for (const MapWork& maps : engine.maps()) {
        const gl::Texture coverage = engine.coverage(maps);
        read.push_back(readMaps(maps, engine.origin(), &coverage));
    }
    return read;
}

std::vector<io::BakedMap> bakedMaps(const Engine& engine, std::vector<MapData> maps) {
    std::vector<io::BakedMap> baked;
    for (std::size_t i = 0; i < maps.size(); ++i)
        baked.push_back(bakedMap(engine, engine.maps()[i], std::move(maps[i])));
    return baked;
}

} // namespace limpid::apps
