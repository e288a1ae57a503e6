#include "view/WaterPass.h"

#include <cmath>

#include "gl/Bindings.h"
#include "gl/Blending.h"

namespace limpid {

WaterPass::WaterPass() : _water({"view/water.vert", "view/water.frag"}) {}

void WaterPass::drawGrid(const Inputs& inputs) {
    gl::VertexArray grid;
    grid.attribute(positionAttribute, inputs.surface.positions, 4, 0, 16);
    grid.attribute(normalAttribute, inputs.surface.normals, 4, 0, 16);
    grid.indices(inputs.surface.indices);
    grid.bind();
    _water.set(holeLocation, glm::vec4(0));
    _water.set(flatRestLocation, 0);
    glDrawElements(GL_TRIANGLES, 3 * inputs.surface.triangleCount, GL_UNSIGNED_INT, nullptr);
}

/// The flat rest, out to where it is a line in any picture.
void WaterPass::drawHorizon(const Inputs& inputs) {
    const glm::dvec3& camera = *inputs.scene.camera.position;
    const double reach =
        1000 * (glm::length(inputs.patch.size) + std::abs(camera.y - inputs.scene.water.level));
    const glm::dvec2 foot(camera.x, camera.z), origin(inputs.origin.x, inputs.origin.z);
    _water.set(horizonLocation, glm::vec4(foot - reach - origin, foot + reach - origin));
    _noVertices.bind();
    // The two overlap a little, or the sky shows through between them; at the rim both are flat.
    const glm::vec4& patch = inputs.frame.patchRect;
    constexpr float overlap = 0.002f;
    _water.set(holeLocation, glm::vec4(glm::vec2(patch) + overlap * glm::vec2(patch.z, patch.w),
                                       (1 - 2 * overlap) * glm::vec2(patch.z, patch.w)));
    _water.set(flatRestLocation, 1);
    glDrawArrays(GL_TRIANGLES, 0, 6);
}

void WaterPass::addGlitter(const Inputs& inputs) {
    glDepthFunc(GL_GEQUAL);
    const gl::Adding adding;
    for (std::size_t i = 0; i < inputs.scene.lights.size(); ++i) {
        const Light& light = inputs.scene.lights[i];
        if (light.type != LightType::Directional || !entersWater(light, inputs.scene.water)) continue;
        inputs.lights[i]->frame.bindUniform(lightFrameBlock);
        if (inputs.lights[i]->surfaceShadow) inputs.lights[i]->surfaceShadow->bind(surfaceShadowUnit);
        _water.set(sunLocation, glm::vec3(light.irradiance));
        drawHorizon(inputs);
        drawGrid(inputs);
    }
    glDepthFunc(GL_GREATER);
}

/// First what shines through and what is mirrored, then each sun's glitter on top.
void WaterPass::draw(const Inputs& inputs) {
    inputs.refracted->bind(refractedRadianceUnit);
    inputs.refractedDistance->bind(refractedDistanceUnit);
    inputs.mirrored->bind(mirroredRadianceUnit);
    inputs.mirroredDistance->bind(mirroredDistanceUnit);
    _water.use();
    glEnable(GL_DEPTH_TEST);
    // A camera close to the water has it nearer than the near plane.
    glEnable(GL_DEPTH_CLAMP);
    _water.set(sunLocation, glm::vec3(0));
    drawHorizon(inputs);
    drawGrid(inputs);
    addGlitter(inputs);
    glDisable(GL_DEPTH_CLAMP);
    glDisable(GL_DEPTH_TEST);
}

} // namespace limpid
