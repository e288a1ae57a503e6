#include "view/Picture.h"

#include <limits>

#include "gl/Bindings.h"
#include "gl/Blending.h"
#include "gl/NearIsOne.h"

namespace limpid {

namespace {

constexpr int supersampling = 2; // samples a pixel and axis

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

/// While it lives, only these rows of what is bound can be drawn.
struct RowsOnly {
    explicit RowsOnly(glm::ivec2 rows) {
        glEnablei(GL_SCISSOR_TEST, 0);
        glScissorIndexed(0, 0, rows.x, std::numeric_limits<GLsizei>::max(), rows.y - rows.x);
    }
    ~RowsOnly() { glDisablei(GL_SCISSOR_TEST, 0); }
    RowsOnly(const RowsOnly&) = delete;
    RowsOnly& operator=(const RowsOnly&) = delete;
};

} // namespace

PicturePass::Sketch::View::View(gl::Ledger& ledger, const char* kind, glm::ivec2 size)
    : radiance(ledger, kind, GL_RGBA32F, size), distance(ledger, kind, GL_R32F, size),
      depth(ledger, "depth buffer", GL_DEPTH_COMPONENT32F, size) {
    radiance.setFilter(GL_LINEAR, GL_CLAMP_TO_EDGE);
    const gl::Texture* const targets[] = {&radiance, &distance};
    target = gl::Framebuffer(kind, targets, &depth);
    target.clearColor(glm::vec4(0), radianceTarget);
    target.clearColor(glm::vec4(-1), metresTarget);
    target.clearDepth(0);
}

PicturePass::PicturePass(gl::Context& context) : _context(context), _receivers(context), _water(context) {}

int PicturePass::largestSide(const gl::Context& context) {
    return int(context.info().maxTextureSize / (supersampling * (1 + viewMargin)));
}

void PicturePass::drawView(const ReceiverPass::Inputs& receivers, const gl::Framebuffer& target, Side side,
                           Way way) {
    _receivers.drawSolid(receivers, target, side, way);
    _receivers.drawBlended(receivers, target, side, way);
}

/// To `radiance`. `depth` as drawn, `near` its plane, m.
void PicturePass::addGodrays(const Inputs& inputs, const gl::Texture& radiance, const gl::Texture& depth,
                             float near) {
    if (!_godrays)
        _godrays.emplace(std::initializer_list<const char*>{"gl/screen.vert", "view/godrays.frag"});
    // Without depth, which is read here.
    const gl::Texture* const targets[] = {&radiance};
    const gl::Framebuffer target("picture", targets);
    target.bind();
    inputs.godrays->bind(godraysUnit);
    depth.bind(viewDepthUnit);
    _godrays->set(samplesLocation, radiance.size());
    _godrays->set(nearLocation, near);
    _godrays->set(tapsLocation, inputs.scene.godrays.filterTaps);
    _godrays->set(radiusLocation, float(inputs.scene.godrays.filterRadius));
    _noVertices.bind();
    _godrays->use();
    const gl::Adding adding;
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

ReceiverPass::Inputs PicturePass::receiverInputs(const Inputs& inputs, const ViewFrameData& frame) const {
    return {inputs.scene,  inputs.receivers,         inputs.lit,
            inputs.lights, inputs.surface.positions, glm::vec3(frame.cameraPosition)};
}

PicturePass::Sketch PicturePass::begin(const Inputs& inputs, glm::ivec2 size, int perPixel) {
    gl::Ledger& ledger = _context.ledger();
    const glm::ivec2 samples = size * perPixel;
    const glm::ivec2 wide(glm::ceil(glm::dvec2(samples) * (1 + viewMargin)));
    Sketch sketch;
    sketch._perPixel = perPixel;
    sketch._frame =
        viewFrame(inputs.scene, inputs.origin, inputs.patch, inputs.surface, inputs.sides, samples);
    const ViewFrameData& frame = sketch._frame;
    sketch._view = gl::Buffer(ledger, "view", sizeof(frame), &frame);
    sketch._view.bindUniform(viewFrameBlock);
    const gl::NearIsOne reversed;
    const ReceiverPass::Inputs receivers = receiverInputs(inputs, frame);
    _receivers.prepare(receivers);
    sketch._refracted = Sketch::View(ledger, "refracted view", wide);
    if (frame.hasFarSide()) drawView(receivers, sketch._refracted.target, frame.farSide(), Way::Refracted);
    sketch._mirrored = Sketch::View(ledger, "mirrored view", frame.hasNearSide() ? wide : glm::ivec2(1));
    if (frame.hasNearSide()) drawView(receivers, sketch._mirrored.target, frame.nearSide(), Way::Mirrored);
    sketch._radiance = gl::Texture(ledger, "picture", GL_RGBA32F, samples);
    sketch._depth = gl::Texture(ledger, "depth buffer", GL_DEPTH_COMPONENT32F, samples);
    const gl::Texture* const targets[] = {&sketch._radiance};
    sketch._target = gl::Framebuffer("picture", targets, &sketch._depth);
    sketch._target.clearColor(frame.cameraAbove() ? frame.skyRadiance : frame.deepRadiance);
    sketch._target.clearDepth(0);
    return sketch;
}

void PicturePass::drawRows(const Inputs& inputs, const Sketch& sketch, glm::ivec2 rows) {
    const ViewFrameData& frame = sketch._frame;
    sketch._view.bindUniform(viewFrameBlock);
    const gl::NearIsOne reversed;
    const RowsOnly only(rows * sketch._perPixel);
    const ReceiverPass::Inputs receivers = receiverInputs(inputs, frame);
    _receivers.drawSolid(receivers, sketch._target, frame.nearSide(), Way::Straight);
    _water.draw({inputs.scene, inputs.origin, inputs.patch, inputs.surface, frame, inputs.lights,
                 &sketch._refracted.radiance, &sketch._refracted.distance, &sketch._mirrored.radiance,
                 &sketch._mirrored.distance});
    _receivers.drawBlended(receivers, sketch._target, frame.nearSide(), Way::Straight);
    if (inputs.godrays) addGodrays(inputs, sketch._radiance, sketch._depth, frame.viewProjection[3][2]);
}

Picture PicturePass::draw(const Inputs& inputs, glm::ivec2 size) {
    const Sketch sketch = begin(inputs, size, supersampling);
    drawRows(inputs, sketch, {0, size.y});
    return resolve(sketch.samples().readFloats(GL_RGBA, 4), size);
}

} // namespace limpid
