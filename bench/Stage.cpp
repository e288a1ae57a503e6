#include "Stage.h"

#include <memory>

#include "io/gltf/Gltf.h"
#include "levelmap/SceneDepthMap.h"
#include "plan/FlatWater.h"
#include "plan/Sides.h"
#include "scene/Shapes.h"

namespace limpid::bench {

namespace {

Receiver receiverOf(const StageSize& size) {
    Receiver receiver;
    receiver.name = size.receiver;
    const bool floor = size.receiver == "floor";
    receiver.mesh = std::make_shared<const Mesh>(
        floor ? makePlane({2, 2}, glm::vec3(0.8f))
              : io::loadGltf(std::string(LIMPID_ROOT) + "/models/" + size.receiver + ".glb"));
    receiver.translation = {0, floor ? -1 : -1.5, 0};
    return receiver;
}

Scene sceneOf(const StageSize& size) {
    Scene scene;
    scene.receivers = {receiverOf(size)};
    Light sun;
    if (size.receiver == "floor")
        scene.water.size = glm::dvec2(2), scene.water.center = glm::dvec2(0);
    else
        sun.direction = {0.35, -1, 0.1};
    scene.lights = {sun};
    Wave swell, ripples;
    swell.amplitude = 0.004;
    swell.wavelength = 0.2;
    swell.direction = {1, 0.3};
    ripples.type = WaveType::Noise;
    ripples.amplitude = 0.01;
    ripples.wavelength = 0.3;
    scene.water.waves = {swell, ripples};
    scene.water.grid = glm::ivec2(size.quads);
    return scene;
}

} // namespace

Stage::Stage(gl::Context& gl, const StageSize& asked)
    : context(gl), size(asked), scene(sceneOf(asked)), patch(coveringPatch(scene)), surface(gl), tracer(gl),
      geometry(gl, scene.receivers[0], glm::dvec3(0)), levelMapPass(gl) {
    const Light& sun = scene.lights[0];
    const auto points = pointsOfSide(scene.receivers[0], scene.water.level, Side::Below);
    surface.update(scene.water, patch, glm::dvec3(0), 0);
    LightFrameData frame = lightFrame(sun, scene.water, glm::dvec3(0));
    frame.sceneDepthRect = sceneDepthRect(sun, scene.water, points, glm::dvec3(0));
    tracer.prepare(beams, surface.mesh(), sun, scene.water, frame);
    tracer.trace(beams, surface.mesh(), nullptr);
    const glm::dvec3 light = meanDirection(sun, scene.water, worldBounds(scene.receivers[0]).center());
    const OrientedBox box = tightBox(points, light);
    const Facings facings =
        findFacings(scene.receivers[0], light, scene.water.level, enclosesSolid(scene.receivers[0]));
    const DepthGradients gradients = depthGradients(scene.receivers[0], box, facings, 0, scene.water.level);
    prepareLevelMap(gl, map, {box, facings, gradients, size.mapSize, size.planes, glm::dvec3(0)});
    levelMapPass.draw(map, receiver());
    std::optional<TangentPlanesPass::Rims> rims;
    if (!map.frame.flat) {
        _occluders.emplace(gl, scene.receivers, glm::dvec3(0));
        rims.emplace(TangentPlanesPass::Rims{*_occluders, beams, 0});
    }
    TangentPlanesPass(gl).update(tangents, map, rims ? &*rims : nullptr);
}

} // namespace limpid::bench
