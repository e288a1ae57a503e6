#pragma once
#include "engine/EngineFixture.h"

namespace limpid {

class PictureFixture : public EngineGLTest {
  protected:
    static Picture render(const Scene& scene, glm::ivec2 size) {
        Engine engine(context());
        engine.setScene(scene);
        return engine.render(0, size);
    }
    static glm::dvec3 at(const Picture& picture, int x, int y) {
        const std::size_t i = 3 * (std::size_t(y) * std::size_t(picture.size.x) + std::size_t(x));
        return {picture.rgb[i], picture.rgb[i + 1], picture.rgb[i + 2]};
    }
    static Scene floorFromAbove() {
        Scene scene;
        scene.receivers = {scenes::floorAt(-1, 4)};
        scene.lights = {scenes::sunAt(0)};
        scene.lights[0].irradiance = {3, 2, 1};
        scene.water.grid = {32, 32};
        scene.caustics.mapSize = 256;
        scene.camera.position = {0, 2, 0};
        scene.camera.target = {0, 0, 0};
        return scene;
    }
};

} // namespace limpid
