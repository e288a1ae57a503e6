#pragma once
#include <cmath>

#include "engine/EngineFixture.h"

namespace limpid {

class PictureFixture : public EngineGLTest {
  protected:
    static Picture render(const Scene& scene, glm::ivec2 size) {
        Engine engine(context());
        engine.set(scene);
        return engine.render(0, size);
    }
    static glm::dvec3 at(const Picture& picture, int x, int y) {
        const std::size_t i = 3 * (std::size_t(y) * std::size_t(picture.size.x) + std::size_t(x));
        return {picture.rgb[i], picture.rgb[i + 1], picture.rgb[i + 2]};
    }
    /// Right, up and back of a camera that looks along -z.
    static glm::dmat3 axesOf(const Camera& camera) {
        const glm::dvec3 back = glm::normalize(*camera.position - *camera.target);
        const glm::dvec3 right = glm::normalize(glm::cross(camera.up, back));
        return {right, glm::cross(back, right), back};
    }
    /// Half a picture's height, in pixels, at a distance of 1.
    static double focus(const Camera& camera, glm::ivec2 size) {
        return 0.5 * size.y / std::tan(0.5 * glm::radians(camera.verticalFov));
    }
    /// Where a picture shows `point` if nothing bends the way there, in pixels from the upper left.
    static glm::dvec2 pixelOf(const Camera& camera, const glm::dvec3& point, glm::ivec2 size) {
        const glm::dvec3 seen = glm::transpose(axesOf(camera)) * (point - *camera.position);
        return 0.5 * glm::dvec2(size) + focus(camera, size) / -seen.z * glm::dvec2(seen.x, -seen.y);
    }
    /// Unit direction of the ray through the middle of a pixel.
    static glm::dvec3 rayThrough(const Camera& camera, glm::ivec2 pixel, glm::ivec2 size) {
        const glm::dvec2 at = glm::dvec2(pixel) + 0.5 - 0.5 * glm::dvec2(size);
        return glm::normalize(axesOf(camera) * glm::dvec3(at.x, -at.y, -focus(camera, size)));
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
