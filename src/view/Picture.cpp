#include "view/Picture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "core/Optics.h"

namespace limpid {

namespace {

constexpr int supersampling = 2;          // samples a pixel and axis
constexpr double underwaterMargin = 0.15; // of the view's half width: waves look past its edge
constexpr glm::ivec2 groupSize{8, 8};
constexpr GLuint viewBinding = 2;
enum ReceiverUniform { Underwater, WithAmbient, WithCaustics, Strength };

enum WaterUniform { Hole, PatchRect, Sun };
enum ScreenUniform { TargetSize = 1 };

struct ViewFrameData {
    glm::mat4 viewProjection;
    glm::vec4 cameraPosition, ambientRadiance, skyRadiance, waterExtinction, viewWater, deepRadiance;
};

/// An upper bound on metres of water between the camera's rays and any receiver. Waves bend rays further than
/// flat water does; a quarter more has room for it.
double farthestSeen(const Bounds& bounds, const Water& water, const glm::dvec3& camera) {
    double farthest = 1e-6;
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 corner(i & 1 ? bounds.max.x : bounds.min.x, i & 2 ? bounds.max.y : bounds.min.y,
                                i & 4 ? bounds.max.z : bounds.min.z);
        const double above = camera.y - water.level, below = std::max(water.level - corner.y, 0.0);
        const double across = glm::distance(glm::dvec2(camera.x, camera.z), glm::dvec2(corner.x, corner.z));
        const double rest =
            above > 0 ? across - optics::flatCrossing(above, below, across, water.ior) : across;
        farthest = std::max(farthest, above > 0 ? std::hypot(rest, below) : glm::distance(corner, camera));
    }
    return 1.25 * farthest;
}

/// Nothing nearer than this is seen, m: a thousandth of the way to what the picture is about.
double nearPlane(const Bounds& bounds, const Camera& camera) {
    const double toScene =
        bounds.empty() ? 1e300
                       : glm::distance(*camera.position, bounds.center()) + glm::length(bounds.size());
    return 1e-3 * std::max(std::min(glm::distance(*camera.position, *camera.target), toScene), 1e-9);
}

/// Radiance of endless water in which the ambient light is the same everywhere: what each metre scatters into
/// a ray balances what extinction takes from it.
glm::dvec3 deepRadiance(const Scene& scene) {
    glm::dvec3 deep = scene.ambientRadiance;
    for (int c = 0; c < 3; ++c) {
        const double lost = scene.water.absorption[c] + scene.water.scattering[c];
        if (lost > 0) deep[c] *= scene.water.scattering[c] / lost;
    }
    return deep;
}

glm::vec4 patchRect(const PicturePass::Inputs& inputs) {
    return glm::vec4(inputs.patch.min() - glm::dvec2(inputs.origin.x, inputs.origin.z), inputs.patch.size);
}

ViewFrameData viewFrame(const PicturePass::Inputs& inputs, glm::ivec2 size) {
    const Scene& scene = inputs.scene;
    const Camera& camera = scene.camera;
    const glm::dvec3 position = *camera.position - inputs.origin, target = *camera.target - inputs.origin;
    const Bounds bounds = worldBounds(scene);
    const double near = nearPlane(bounds, camera);
    const glm::dmat4 projection =
        glm::infinitePerspective(glm::radians(camera.verticalFov), double(size.x) / double(size.y), near);
    const glm::dvec3 forward = glm::normalize(target - position);
    // Looking along `up`, any other axis serves.
    const bool vertical = glm::length(glm::cross(forward, glm::normalize(camera.up))) < 1e-6;
    const glm::dmat4 view = glm::lookAt(position, target, vertical ? glm::dvec3(0, 0, -1) : camera.up);
    ViewFrameData frame;
    frame.viewProjection = projection * view;
    frame.cameraPosition = glm::vec4(position, camera.position->y > scene.water.level ? 1 : 0);
    frame.ambientRadiance = glm::vec4(scene.ambientRadiance, 0);
    frame.skyRadiance = glm::vec4(scene.skyRadiance, 0);
    frame.waterExtinction = glm::vec4(scene.water.absorption + scene.water.scattering,
                                      farthestSeen(bounds, scene.water, *camera.position));
    frame.viewWater =
        glm::vec4(scene.water.level - inputs.origin.y, scene.water.ior, 1 / (1 + underwaterMargin), 0);
    frame.deepRadiance = glm::vec4(deepRadiance(scene), 0);
    return frame;
}

/// Average of each pixel's samples; OpenGL counts rows from the bottom, a picture from the top.
Picture resolve(const std::vector<float>& samples, glm::ivec2 size) {
    Picture picture{size, std::vector<float>(std::size_t(size.x) * std::size_t(size.y) * 3)};
    constexpr float share = 1.0f / float(supersampling * supersampling);
    const int width = size.x * supersampling;
    for (int y = 0; y < size.y * supersampling; ++y)
        for (int x = 0; x < width; ++x) {
            const std::size_t from = (std::size_t(y) * std::size_t(width) + std::size_t(x)) * 4;
            const std::size_t row = std::size_t(size.y - 1 - y / supersampling);
            float* to = &picture.rgb[(row * std::size_t(size.x) + std::size_t(x / supersampling)) * 3];
            for (int c = 0; c < 3; ++c)
                to[c] += share * samples[from + std::size_t(c)];
        }
    return picture;
}

} // namespace

PicturePass::PicturePass(gl::Context& context)
    : _context(context), _castMap({"view/cast_map.comp"}),
      _receiver({"view/receiver.vert", "view/receiver.tesc", "view/receiver.tese", "levelmap/face.geom",
                 "view/receiver.frag"}),
      _water({"view/water.vert", "view/water.frag"}),
      _underwaterScreen({"gl/screen.vert", "view/underwater_screen.frag"}) {}

int PicturePass::largestSide(const gl::Context& context) {
    return int(context.info().maxTextureSize / (supersampling * (1 + underwaterMargin)));
}

gl::Texture PicturePass::castMap(const Lit& lit) {
    gl::Texture map(_context.ledger(), "cast map", GL_RGBA32F, lit.level->frame.size);
    lit.caustics->irradiance.bind(0);
    lit.level->position.bind(1);
    map.bindImage(0, GL_WRITE_ONLY);
    _castMap.dispatch2D(map.size(), groupSize);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    return map;
}

void PicturePass::addCaustics(const Inputs& inputs, std::size_t receiver) {
    _receiver.set(WithCaustics, 1);
    for (const Lit& lit : inputs.lit) {
        if (lit.receiver != int(receiver)) continue;
        const gl::Texture cast = castMap(lit);
        lit.level->box.bindUniform(1);
        cast.bind(1);
        inputs.receivers[receiver].draw(_receiver, GL_PATCHES);
    }
    _receiver.set(WithCaustics, 0);
}

/// What does not go through the surface: light on what stands out of the water, and lamps below it.
void PicturePass::addDirectLight(const Inputs& inputs, std::size_t receiver, bool underwater) {
    for (std::size_t i = 0; i < inputs.scene.lights.size(); ++i) {
        const Light& light = inputs.scene.lights[i];
        const bool sunken = light.type == LightType::Point && light.position.y < inputs.scene.water.level;
        if (sunken != underwater) continue;
        inputs.lights[i]->frame.bindUniform(0);
        if (inputs.lights[i]->surfaceShadow) inputs.lights[i]->surfaceShadow->bind(surfaceShadowUnit);
        _receiver.set(Strength,
                      glm::vec3(light.type == LightType::Point ? light.intensity : light.irradiance));
        inputs.receivers[receiver].draw(_receiver, GL_PATCHES);
    }
    _receiver.set(Strength, glm::vec3(0));
}

/// One pass for each receiver and light; the first brings the ambient light, the others add to it.
void PicturePass::drawReceivers(const Inputs& inputs, const gl::Framebuffer& target, bool underwater) {
    target.bind();
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glPatchParameteri(GL_PATCH_VERTICES, 3);
    _receiver.set(Underwater, underwater ? 1 : 0);
    _receiver.set(WithCaustics, 0);
    _receiver.set(Strength, glm::vec3(0));
    glBlendFunci(0, GL_ONE, GL_ONE);
    for (std::size_t i = 0; i < inputs.receivers.size(); ++i) {
        _receiver.set(WithAmbient, 1);
        inputs.receivers[i].draw(_receiver, GL_PATCHES);
        _receiver.set(WithAmbient, 0);
        glEnablei(GL_BLEND, 0);
        if (underwater) addCaustics(inputs, i);
        addDirectLight(inputs, i, underwater);
        glDisablei(GL_BLEND, 0);
    }
    glDepthFunc(GL_LESS);
    glDisable(GL_DEPTH_TEST);
}

void PicturePass::drawGrid(const Inputs& inputs) {
    gl::VertexArray grid;
    grid.attribute(0, inputs.surface.positions, 4, 0, 16);
    grid.attribute(1, inputs.surface.normals, 4, 0, 16);
    grid.indices(inputs.surface.indices);
    grid.bind();
    _water.set(Hole, glm::vec4(0));
    _water.set(PatchRect, patchRect(inputs));
    glDrawElements(GL_TRIANGLES, 3 * inputs.surface.triangleCount, GL_UNSIGNED_INT, nullptr);
}

/// The flat rest, out to where it is a line in any picture.
void PicturePass::drawHorizon(const Inputs& inputs) {
    const glm::dvec3& camera = *inputs.scene.camera.position;
    const double reach =
        1000 * (glm::length(inputs.patch.size) + std::abs(camera.y - inputs.scene.water.level));
    std::array<glm::vec4, 12> vertices;
    constexpr int corners[] = {0, 1, 2, 2, 1, 3};
    for (std::size_t i = 0; i < 6; ++i) {
        const glm::dvec2 side(corners[i] & 1 ? 1 : -1, corners[i] & 2 ? 1 : -1);
        vertices[2 * i] = glm::vec4(
            glm::dvec3(camera.x + reach * side.x, inputs.scene.water.level, camera.z + reach * side.y) -
                inputs.origin,
            1);
        vertices[2 * i + 1] = {0, 1, 0, 0};
    }
    const gl::Buffer buffer(_context.ledger(), "water", std::span<const glm::vec4>(vertices));
    gl::VertexArray quad;
    quad.attribute(0, buffer, 4, 0, 32);
    quad.attribute(1, buffer, 4, 16, 32);
    quad.bind();
    // The two overlap a little, or the sky shows through between them; at the rim both are flat.
    const glm::vec4 patch = patchRect(inputs);
    constexpr float overlap = 0.002f;
    _water.set(Hole, glm::vec4(glm::vec2(patch) + overlap * glm::vec2(patch.z, patch.w),
                               (1 - 2 * overlap) * glm::vec2(patch.z, patch.w)));
    _water.set(PatchRect, glm::vec4(0));
    glDrawArrays(GL_TRIANGLES, 0, 6);
}

/// First what shines through and the sky, then each sun's glitter on top.
void PicturePass::drawWater(const Inputs& inputs) {
    _water.use();
    glEnable(GL_DEPTH_TEST);
    _water.set(Sun, glm::vec3(0));
    drawHorizon(inputs);
    drawGrid(inputs);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    for (std::size_t i = 0; i < inputs.scene.lights.size(); ++i) {
        const Light& light = inputs.scene.lights[i];
        if (light.type != LightType::Directional || !entersWater(light, inputs.scene.water)) continue;
        inputs.lights[i]->frame.bindUniform(0);
        if (inputs.lights[i]->surfaceShadow) inputs.lights[i]->surfaceShadow->bind(surfaceShadowUnit);
        _water.set(Sun, glm::vec3(light.irradiance));
        drawHorizon(inputs);
        drawGrid(inputs);
    }
    glDisable(GL_BLEND);
    glDepthFunc(GL_LESS);
    glDisable(GL_DEPTH_TEST);
}

Picture PicturePass::draw(const Inputs& inputs, glm::ivec2 size) {
    gl::Ledger& ledger = _context.ledger();
    const glm::ivec2 samples = size * supersampling;
    const glm::ivec2 wide(glm::ceil(glm::dvec2(samples) * (1 + underwaterMargin)));
    const ViewFrameData frame = viewFrame(inputs, size);
    const gl::Buffer view(ledger, "view", sizeof(frame), &frame);
    view.bindUniform(viewBinding);

    gl::Texture below(ledger, "underwater view", GL_RGBA32F, wide);
    const gl::Texture belowPosition(ledger, "underwater view", GL_RGBA32F, wide);
    const gl::Texture belowDepth(ledger, "depth buffer", GL_DEPTH_COMPONENT32F, wide);
    below.setFilter(GL_LINEAR, GL_CLAMP_TO_EDGE);
    const gl::Texture* const belowTargets[] = {&below, &belowPosition};
    const gl::Framebuffer underwater("underwater view", belowTargets, &belowDepth);
    underwater.clearColor(0, glm::vec4(0));
    underwater.clearColor(1, {0, 0, 0, 1e30f});
    underwater.clearDepth(1);
    drawReceivers(inputs, underwater, true);

    const gl::Texture radiance(ledger, "picture", GL_RGBA32F, samples);
    const gl::Texture position(ledger, "picture", GL_RGBA32F, samples);
    const gl::Texture depth(ledger, "depth buffer", GL_DEPTH_COMPONENT32F, samples);
    const gl::Texture* const targets[] = {&radiance, &position};
    const gl::Framebuffer picture("picture", targets, &depth);
    const bool above = frame.cameraPosition.w > 0.5f;
    picture.clearColor(0, above ? frame.skyRadiance : frame.deepRadiance);
    picture.clearDepth(1);
    drawReceivers(inputs, picture, false);
    below.bind(0);
    belowPosition.bind(1);
    if (!above) {
        glEnable(GL_DEPTH_TEST);
        _underwaterScreen.set(TargetSize, samples);
        _underwaterScreen.use();
        gl::VertexArray none;
        none.bind();
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glDisable(GL_DEPTH_TEST);
    }
    drawWater(inputs);
    return resolve(radiance.readFloats(GL_RGBA, 4), size);
}

} // namespace limpid
