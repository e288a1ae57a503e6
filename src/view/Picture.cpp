#include "view/Picture.h"

#include <limits>
#include <utility>

#include "gl/Bindings.h"
#include "gl/Blending.h"
#include "gl/NearIsOne.h"

namespace limpid {

namespace {

constexpr int supersampling = 2; // samples a pixel and axis

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
}

void PicturePass::Sketch::View::fit(gl::Ledger& ledger, const char* kind, glm::ivec2 size) {
    if (radiance.size() == size) return;
    *this = View(); // before there is another
    *this = View(ledger, kind, size);
}

void PicturePass::Sketch::View::clear() const {
    target.clearColor(glm::vec4(0), radianceTarget);
    target.clearColor(glm::vec4(-1), metresTarget);
    target.clearDepth(0);
}

PicturePass::PicturePass(gl::Context& context) : _context(context), _receivers(context), _resolve(context) {}

int PicturePass::largestSide(const gl::Context& context) {
    return int(context.info().maxTextureSize / (supersampling * (1 + viewMargin)));
}

void PicturePass::drawView(const ReceiverPass::Inputs& receivers, const gl::Framebuffer& target, Side side,
                           Way way) {
    _receivers.drawSolid(receivers, target, side, way);
    _receivers.drawBlended(receivers, target, side, way);
}

void PicturePass::addGodrays(const Inputs& inputs, const Sketch& sketch) {
    if (!_godrays)
        _godrays.emplace(std::initializer_list<const char*>{"gl/screen.vert", "view/godrays.frag"});
    sketch._withoutDepth.bind(); // depth is read here
    inputs.godrays->bind(godraysUnit);
    sketch._depth.bind(viewDepthUnit);
    _godrays->set(samplesLocation, sketch._radiance.size());
    _godrays->set(nearLocation, sketch._frame.viewProjection[3][2]);
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

/// Brings the targets to the size of a picture; those of another go before.
void PicturePass::fit(Sketch& sketch, glm::ivec2 size, int perPixel) {
    const glm::ivec2 samples = size * perPixel;
    sketch._perPixel = perPixel;
    if (sketch._target.id() && sketch._radiance.size() == samples) return;
    sketch = {};
    sketch._perPixel = perPixel;
    gl::Ledger& ledger = _context.ledger();
    sketch._view = gl::Buffer(ledger, "view", sizeof(ViewFrameData));
    sketch._radiance = gl::Texture(ledger, "picture", GL_RGBA32F, samples);
    sketch._depth = gl::Texture(ledger, "depth buffer", GL_DEPTH_COMPONENT32F, samples);
    const gl::Texture* const targets[] = {&sketch._radiance};
    sketch._withoutDepth = gl::Framebuffer("picture", targets);
    sketch._target = gl::Framebuffer("picture", targets, &sketch._depth);
}

PicturePass::Sketch PicturePass::begin(const Inputs& inputs, glm::ivec2 size, int perPixel, Sketch used) {
    gl::Ledger& ledger = _context.ledger();
    Sketch sketch = std::move(used);
    fit(sketch, size, perPixel);
    const glm::ivec2 samples = size * perPixel;
    const glm::ivec2 wide(glm::ceil(glm::dvec2(samples) * (1 + viewMargin)));
    sketch._frame =
        viewFrame(inputs.scene, inputs.origin, inputs.patch, inputs.sides, inputs.waterHeight, samples);
    const ViewFrameData& frame = sketch._frame;
    sketch._view.write(0, sizeof(frame), &frame);
    sketch._view.bindUniform(viewFrameBlock);
    const gl::NearIsOne reversed;
    const ReceiverPass::Inputs receivers = receiverInputs(inputs, frame);
    _receivers.prepare(receivers);
    sketch._refracted.fit(ledger, "refracted view", wide);
    sketch._refracted.clear();
    if (frame.hasFarSide()) drawView(receivers, sketch._refracted.target, frame.farSide(), Way::Refracted);
    sketch._mirrored.fit(ledger, "mirrored view", frame.hasNearSide() ? wide : glm::ivec2(1));
    sketch._mirrored.clear();
    if (frame.hasNearSide()) drawView(receivers, sketch._mirrored.target, frame.nearSide(), Way::Mirrored);
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
    if (inputs.godrays) addGodrays(inputs, sketch);
}

void PicturePass::drawWhole(const Inputs& inputs, glm::ivec2 size) {
    _drawn = begin(inputs, size, supersampling, std::move(_drawn));
    drawRows(inputs, _drawn, {0, size.y});
}

Picture PicturePass::draw(const Inputs& inputs, glm::ivec2 size) {
    drawWhole(inputs, size);
    return _resolve.linear(_drawn.samples(), supersampling);
}

std::vector<std::uint8_t> PicturePass::drawToneMapped(const Inputs& inputs, glm::ivec2 size) {
    drawWhole(inputs, size);
    return _resolve.toneMapped(_drawn.samples(), supersampling, inputs.scene.camera.exposure);
}

} // namespace limpid
