#include "gl/HostState.h"

namespace limpid::gl {

namespace {

/// `index` < 0: of the whole context.
struct Capability {
    GLenum name;
    int index = -1;
};
/// All of them are off in a fresh context, or of no consequence while they are.
constexpr Capability capabilityTable[] = {
    {GL_CULL_FACE},
    {GL_STENCIL_TEST},
    {GL_DEPTH_TEST},
    {GL_DEPTH_CLAMP},
    {GL_RASTERIZER_DISCARD},
    {GL_POLYGON_OFFSET_FILL},
    {GL_POLYGON_OFFSET_LINE},
    {GL_POLYGON_OFFSET_POINT},
    {GL_POLYGON_SMOOTH},
    {GL_PRIMITIVE_RESTART},
    {GL_PRIMITIVE_RESTART_FIXED_INDEX},
    {GL_SAMPLE_MASK},
    {GL_SAMPLE_COVERAGE},
    {GL_SAMPLE_ALPHA_TO_COVERAGE},
    {GL_SAMPLE_ALPHA_TO_ONE},
    {GL_SAMPLE_SHADING},
    {GL_COLOR_LOGIC_OP},
    {GL_FRAMEBUFFER_SRGB},
    {GL_PROGRAM_POINT_SIZE},
    {GL_LINE_SMOOTH},
    {GL_DITHER},
    {GL_SCISSOR_TEST, 0},
    {GL_BLEND, 0},
    {GL_BLEND, 1},
    {GL_BLEND, 2},
    {GL_BLEND, 3},
    {GL_CLIP_DISTANCE0},
    {GL_CLIP_DISTANCE1},
    {GL_CLIP_DISTANCE2},
    {GL_CLIP_DISTANCE3},
    {GL_CLIP_DISTANCE4},
    {GL_CLIP_DISTANCE5},
    {GL_CLIP_DISTANCE6},
    {GL_CLIP_DISTANCE7},
};

struct BufferTarget {
    GLenum target, binding;
};
constexpr BufferTarget bufferTable[] = {{GL_DRAW_INDIRECT_BUFFER, GL_DRAW_INDIRECT_BUFFER_BINDING},
                                        {GL_DISPATCH_INDIRECT_BUFFER, GL_DISPATCH_INDIRECT_BUFFER_BINDING},
                                        {GL_SHADER_STORAGE_BUFFER, GL_SHADER_STORAGE_BUFFER_BINDING},
                                        {GL_UNIFORM_BUFFER, GL_UNIFORM_BUFFER_BINDING}};

bool isOn(const Capability& c) {
    return (c.index < 0 ? glIsEnabled(c.name) : glIsEnabledi(c.name, GLuint(c.index))) == GL_TRUE;
}

void turn(const Capability& c, bool on) {
    if (c.index < 0)
        on ? glEnable(c.name) : glDisable(c.name);
    else
        on ? glEnablei(c.name, GLuint(c.index)) : glDisablei(c.name, GLuint(c.index));
}

GLint integer(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

GLint integer(GLenum name, std::size_t index) {
    GLint value = 0;
    glGetIntegeri_v(name, GLuint(index), &value);
    return value;
}

/// All 32, which are cut down to the largest integer otherwise.
GLuint bits(GLenum name) {
    GLint64 value = 0;
    glGetInteger64v(name, &value);
    return GLuint(value);
}

template <typename Ranges>
void readRanges(Ranges& ranges, GLenum binding, GLenum start, GLenum size) {
    for (std::size_t i = 0; i < ranges.size(); ++i) {
        ranges[i].buffer = integer(binding, i);
        if (ranges[i].buffer == 0) continue;
        glGetInteger64i_v(start, GLuint(i), &ranges[i].start);
        glGetInteger64i_v(size, GLuint(i), &ranges[i].size);
    }
}

template <typename Ranges>
void setRanges(const Ranges& ranges, GLenum target) {
    for (std::size_t i = 0; i < ranges.size(); ++i)
        if (ranges[i].size > 0)
            glBindBufferRange(target, GLuint(i), GLuint(ranges[i].buffer), ranges[i].start, ranges[i].size);
        else
            glBindBufferBase(target, GLuint(i), GLuint(ranges[i].buffer));
}

} // namespace

HostState::HostState() : _numbers(read()) {
    static_assert(std::size(capabilityTable) == capabilities && std::size(bufferTable) == bufferTargets);
    for (std::size_t i = 0; i < capabilities; ++i) {
        _on[i] = isOn(capabilityTable[i]);
        if (_on[i]) turn(capabilityTable[i], false);
    }
    glGetFloati_v(GL_VIEWPORT, 0, &_viewport.x);
    glGetIntegeri_v(GL_SCISSOR_BOX, 0, &_scissor.x);
    _feedback = integer(GL_TRANSFORM_FEEDBACK_ACTIVE) != 0 && integer(GL_TRANSFORM_FEEDBACK_PAUSED) == 0;
    if (_feedback) glPauseTransformFeedback();
    readBindings();
    glBindSamplers(0, textureUnits, nullptr);
    set(fresh());
}

HostState::~HostState() {
    set(_numbers);
    setBindings();
    glViewportIndexedfv(0, &_viewport.x);
    glScissorIndexedv(0, &_scissor.x);
    for (std::size_t i = 0; i < capabilities; ++i)
        turn(capabilityTable[i], _on[i]);
    if (_feedback) glResumeTransformFeedback();
}

HostState::Numbers HostState::fresh() {
    Numbers numbers;
    for (auto& mask : numbers.written)
        mask.fill(GL_TRUE);
    return numbers;
}

HostState::Numbers HostState::read() {
    Numbers n;
    constexpr GLenum functions[] = {GL_BLEND_SRC_RGB, GL_BLEND_DST_RGB, GL_BLEND_SRC_ALPHA,
                                    GL_BLEND_DST_ALPHA};
    for (std::size_t i = 0; i < blendedBuffers; ++i) {
        for (std::size_t k = 0; k < 4; ++k)
            n.blends[i].functions[k] = integer(functions[k], i);
        n.blends[i].equations = {integer(GL_BLEND_EQUATION_RGB, i), integer(GL_BLEND_EQUATION_ALPHA, i)};
    }
    for (std::size_t i = 0; i < drawBuffers; ++i)
        glGetBooleani_v(GL_COLOR_WRITEMASK, GLuint(i), n.written[i].data());
    n.stencils[0] = {
        integer(GL_STENCIL_FUNC),
        integer(GL_STENCIL_REF),
        bits(GL_STENCIL_VALUE_MASK),
        {integer(GL_STENCIL_FAIL), integer(GL_STENCIL_PASS_DEPTH_FAIL), integer(GL_STENCIL_PASS_DEPTH_PASS)},
        bits(GL_STENCIL_WRITEMASK)};
    n.stencils[1] = {integer(GL_STENCIL_BACK_FUNC),
                     integer(GL_STENCIL_BACK_REF),
                     bits(GL_STENCIL_BACK_VALUE_MASK),
                     {integer(GL_STENCIL_BACK_FAIL), integer(GL_STENCIL_BACK_PASS_DEPTH_FAIL),
                      integer(GL_STENCIL_BACK_PASS_DEPTH_PASS)},
                     bits(GL_STENCIL_BACK_WRITEMASK)};
    n.frontFace = integer(GL_FRONT_FACE);
    GLint modes[2]{};
    glGetIntegerv(GL_POLYGON_MODE, modes);
    n.polygonMode = modes[0];
    n.clipOrigin = integer(GL_CLIP_ORIGIN), n.clipDepth = integer(GL_CLIP_DEPTH_MODE);
    n.provoking = integer(GL_PROVOKING_VERTEX);
    n.patch = integer(GL_PATCH_VERTICES);
    n.depthFunction = integer(GL_DEPTH_FUNC);
    glGetBooleanv(GL_DEPTH_WRITEMASK, &n.depthWritten);
    glGetDoublei_v(GL_DEPTH_RANGE, 0, &n.depthRange.x);
    return n;
}

void HostState::set(const Numbers& n) {
    for (std::size_t i = 0; i < blendedBuffers; ++i) {
        const auto& [functions, equations] = n.blends[i];
        glBlendFuncSeparatei(GLuint(i), GLenum(functions[0]), GLenum(functions[1]), GLenum(functions[2]),
                             GLenum(functions[3]));
        glBlendEquationSeparatei(GLuint(i), GLenum(equations[0]), GLenum(equations[1]));
    }
    for (std::size_t i = 0; i < drawBuffers; ++i)
        glColorMaski(GLuint(i), n.written[i][0], n.written[i][1], n.written[i][2], n.written[i][3]);
    for (const GLenum face : {GL_FRONT, GL_BACK}) {
        const Stencil& s = n.stencils[face == GL_FRONT ? 0 : 1];
        glStencilFuncSeparate(face, GLenum(s.function), s.reference, s.mask);
        glStencilOpSeparate(face, GLenum(s.operations[0]), GLenum(s.operations[1]), GLenum(s.operations[2]));
        glStencilMaskSeparate(face, s.written);
    }
    glFrontFace(GLenum(n.frontFace));
    glPolygonMode(GL_FRONT_AND_BACK, GLenum(n.polygonMode));
    glClipControl(GLenum(n.clipOrigin), GLenum(n.clipDepth));
    glProvokingVertex(GLenum(n.provoking));
    glPatchParameteri(GL_PATCH_VERTICES, n.patch);
    glDepthFunc(GLenum(n.depthFunction));
    glDepthMask(n.depthWritten);
    glDepthRangeIndexed(0, n.depthRange.x, n.depthRange.y);
}

void HostState::readBindings() {
    for (std::size_t i = 0; i < bufferTargets; ++i)
        _buffers[i] = integer(bufferTable[i].binding);
    _activeUnit = integer(GL_ACTIVE_TEXTURE);
    for (std::size_t i = 0; i < textureUnits; ++i) {
        glActiveTexture(GLenum(GL_TEXTURE0 + i));
        _units[i] = {integer(GL_TEXTURE_BINDING_2D), integer(GL_TEXTURE_BINDING_2D_ARRAY),
                     integer(GL_SAMPLER_BINDING)};
    }
    for (std::size_t i = 0; i < imageUnits; ++i) {
        Image& image = _images[i];
        image.texture = integer(GL_IMAGE_BINDING_NAME, i);
        if (image.texture == 0) continue;
        image.level = integer(GL_IMAGE_BINDING_LEVEL, i),
        image.layered = integer(GL_IMAGE_BINDING_LAYERED, i);
        image.layer = integer(GL_IMAGE_BINDING_LAYER, i), image.access = integer(GL_IMAGE_BINDING_ACCESS, i);
        image.format = integer(GL_IMAGE_BINDING_FORMAT, i);
    }
    readRanges(_storage, GL_SHADER_STORAGE_BUFFER_BINDING, GL_SHADER_STORAGE_BUFFER_START,
               GL_SHADER_STORAGE_BUFFER_SIZE);
    readRanges(_uniform, GL_UNIFORM_BUFFER_BINDING, GL_UNIFORM_BUFFER_START, GL_UNIFORM_BUFFER_SIZE);
    _vertexArray = integer(GL_VERTEX_ARRAY_BINDING);
    _program = integer(GL_CURRENT_PROGRAM);
    _drawn = integer(GL_DRAW_FRAMEBUFFER_BINDING), _read = integer(GL_READ_FRAMEBUFFER_BINDING);
}

void HostState::setBindings() const {
    for (std::size_t i = 0; i < textureUnits; ++i) {
        glActiveTexture(GLenum(GL_TEXTURE0 + i));
        glBindTexture(GL_TEXTURE_2D, GLuint(_units[i].plain));
        glBindTexture(GL_TEXTURE_2D_ARRAY, GLuint(_units[i].layered));
        if (_units[i].sampler != 0) glBindSampler(GLuint(i), GLuint(_units[i].sampler));
    }
    glActiveTexture(GLenum(_activeUnit));
    for (std::size_t i = 0; i < imageUnits; ++i) {
        const Image& image = _images[i];
        glBindImageTexture(GLuint(i), GLuint(image.texture), image.level, GLboolean(image.layered != 0),
                           image.layer, GLenum(image.access), GLenum(image.format));
    }
    // These change the plain targets too, which therefore come last.
    setRanges(_storage, GL_SHADER_STORAGE_BUFFER);
    setRanges(_uniform, GL_UNIFORM_BUFFER);
    for (std::size_t i = 0; i < bufferTargets; ++i)
        glBindBuffer(bufferTable[i].target, GLuint(_buffers[i]));
    glBindVertexArray(GLuint(_vertexArray));
    // One that was deleted while in use has gone with our first.
    glUseProgram(glIsProgram(GLuint(_program)) ? GLuint(_program) : 0);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(_drawn));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, GLuint(_read));
}

} // namespace limpid::gl
