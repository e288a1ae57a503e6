#pragma once
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "gl/Api.h"

namespace limpid {

/// One OpenGL state that a host may have left behind, one that would spoil our passes where it can.
struct Hostile {
    std::string name;
    std::function<void()> set;
    std::function<void()> end = [] {}; ///< what setting another state does not undo
};

/// A host's own objects.
struct HostObjects {
    GLuint buffer = 0, vertexArray = 0, framebuffer = 0, sampler = 0, program = 0;
    std::array<GLuint, 3> textures{}; ///< 2D, 2D array, 3D

    HostObjects() {
        glCreateBuffers(1, &buffer);
        glNamedBufferStorage(buffer, 1 << 16, nullptr, GL_DYNAMIC_STORAGE_BIT);
        glCreateVertexArrays(1, &vertexArray);
        glCreateSamplers(1, &sampler);
        glSamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
        glSamplerParameteri(sampler, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        glSamplerParameteri(sampler, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
        constexpr GLenum targets[] = {GL_TEXTURE_2D, GL_TEXTURE_2D_ARRAY, GL_TEXTURE_3D};
        for (std::size_t i = 0; i < textures.size(); ++i)
            glCreateTextures(targets[i], 1, &textures[i]);
        glTextureStorage2D(textures[0], 1, GL_RGBA8, 4, 4);
        glTextureStorage3D(textures[1], 1, GL_RGBA8, 4, 4, 2);
        glTextureStorage3D(textures[2], 1, GL_RGBA8, 4, 4, 2);
        glCreateFramebuffers(1, &framebuffer);
        glNamedFramebufferTexture(framebuffer, GL_COLOR_ATTACHMENT0, textures[0], 0);
        program = makeProgram();
    }
    ~HostObjects() {
        glDeleteBuffers(1, &buffer);
        glDeleteVertexArrays(1, &vertexArray);
        glDeleteFramebuffers(1, &framebuffer);
        glDeleteSamplers(1, &sampler);
        glDeleteProgram(program);
        glDeleteTextures(GLsizei(textures.size()), textures.data());
    }
    static GLuint makeProgram() {
        const char* source = "#version 450\nout vec4 kept; void main() { kept = gl_Position = vec4(1.0); }";
        const GLuint shader = glCreateShader(GL_VERTEX_SHADER);
        glShaderSource(shader, 1, &source, nullptr);
        glCompileShader(shader);
        const GLuint program = glCreateProgram();
        glAttachShader(program, shader);
        const char* varying = "kept";
        glTransformFeedbackVaryings(program, 1, &varying, GL_INTERLEAVED_ATTRIBS);
        glLinkProgram(program);
        glDeleteShader(shader);
        return program;
    }
    HostObjects(const HostObjects&) = delete;
    HostObjects& operator=(const HostObjects&) = delete;
};

inline std::vector<Hostile> hostileStates(const HostObjects& host) {
    const auto on = [](GLenum capability) { return [capability] { glEnable(capability); }; };
    const auto off = [](GLenum capability) { return [capability] { glDisable(capability); }; };
    return {
        {"blend",
         [] {
             glEnable(GL_BLEND);
             glBlendFuncSeparate(GL_ZERO, GL_DST_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO);
             glBlendEquationSeparate(GL_FUNC_REVERSE_SUBTRACT, GL_MAX);
             glBlendColor(0.1f, 0.2f, 0.3f, 0.4f);
         },
         [] {
             glDisable(GL_BLEND);
             glBlendFunc(GL_ONE, GL_ZERO);
             glBlendEquation(GL_FUNC_ADD);
         }},
        {"cull face",
         [] {
             glEnable(GL_CULL_FACE);
             glCullFace(GL_FRONT_AND_BACK);
         },
         off(GL_CULL_FACE)},
        {"front face", [] { glFrontFace(GL_CW); }, [] { glFrontFace(GL_CCW); }},
        {"scissor",
         [] {
             glEnable(GL_SCISSOR_TEST);
             glScissor(1, 2, 3, 4);
         },
         off(GL_SCISSOR_TEST)},
        {"stencil",
         [] {
             glEnable(GL_STENCIL_TEST);
             glStencilFuncSeparate(GL_FRONT, GL_NEVER, 3, 0x55);
             glStencilFuncSeparate(GL_BACK, GL_LESS, 5, 0xaa);
             glStencilOpSeparate(GL_FRONT, GL_INVERT, GL_INCR, GL_DECR);
             glStencilMask(0);
         },
         [] {
             glDisable(GL_STENCIL_TEST);
             glStencilMask(~0u);
         }},
        {"depth function and test",
         [] {
             glEnable(GL_DEPTH_TEST);
             glDepthFunc(GL_NEVER);
         },
         [] {
             glDisable(GL_DEPTH_TEST);
             glDepthFunc(GL_LESS);
         }},
        {"depth mask", [] { glDepthMask(GL_FALSE); }, [] { glDepthMask(GL_TRUE); }},
        {"depth range", [] { glDepthRange(0.4, 0.3); }, [] { glDepthRange(0, 1); }},
        {"depth clamp", on(GL_DEPTH_CLAMP), off(GL_DEPTH_CLAMP)},
        {"clip control", [] { glClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE); },
         [] { glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE); }},
        {"clip distances",
         [] {
             for (GLenum i = 0; i < 8; ++i)
                 glEnable(GL_CLIP_DISTANCE0 + i);
         },
         [] {
             for (GLenum i = 0; i < 8; ++i)
                 glDisable(GL_CLIP_DISTANCE0 + i);
         }},
        {"colour mask",
         [] {
             glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_FALSE);
             glColorMaski(2, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
         },
         [] { glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE); }},
        {"rasterizer discard", on(GL_RASTERIZER_DISCARD), off(GL_RASTERIZER_DISCARD)},
        {"polygon mode", [] { glPolygonMode(GL_FRONT_AND_BACK, GL_LINE); },
         [] { glPolygonMode(GL_FRONT_AND_BACK, GL_FILL); }},
        {"polygon offset",
         [] {
             glEnable(GL_POLYGON_OFFSET_FILL);
             glPolygonOffset(1e3f, 1e6f);
         },
         off(GL_POLYGON_OFFSET_FILL)},
        {"primitive restart",
         [] {
             glEnable(GL_PRIMITIVE_RESTART);
             glPrimitiveRestartIndex(2);
         },
         off(GL_PRIMITIVE_RESTART)},
        {"sample mask",
         [] {
             glEnable(GL_SAMPLE_MASK);
             glSampleMaski(0, 0);
         },
         [] {
             glDisable(GL_SAMPLE_MASK);
             glSampleMaski(0, ~0u);
         }},
        {"sample coverage",
         [] {
             glEnable(GL_SAMPLE_COVERAGE);
             glSampleCoverage(0, GL_FALSE);
         },
         off(GL_SAMPLE_COVERAGE)},
        {"alpha to coverage", on(GL_SAMPLE_ALPHA_TO_COVERAGE), off(GL_SAMPLE_ALPHA_TO_COVERAGE)},
        {"alpha to one", on(GL_SAMPLE_ALPHA_TO_ONE), off(GL_SAMPLE_ALPHA_TO_ONE)},
        {"logic operation",
         [] {
             glEnable(GL_COLOR_LOGIC_OP);
             glLogicOp(GL_CLEAR);
         },
         off(GL_COLOR_LOGIC_OP)},
        {"sRGB", on(GL_FRAMEBUFFER_SRGB), off(GL_FRAMEBUFFER_SRGB)},
        {"dither", off(GL_DITHER), on(GL_DITHER)},
        {"provoking vertex", [] { glProvokingVertex(GL_FIRST_VERTEX_CONVENTION); },
         [] { glProvokingVertex(GL_LAST_VERTEX_CONVENTION); }},
        {"patch vertices", [] { glPatchParameteri(GL_PATCH_VERTICES, 7); },
         [] { glPatchParameteri(GL_PATCH_VERTICES, 3); }},
        {"point size", on(GL_PROGRAM_POINT_SIZE), off(GL_PROGRAM_POINT_SIZE)},
        {"pixel store, reading",
         [] {
             glPixelStorei(GL_PACK_ALIGNMENT, 8);
             glPixelStorei(GL_PACK_ROW_LENGTH, 777);
             glPixelStorei(GL_PACK_SKIP_ROWS, 3);
             glPixelStorei(GL_PACK_SWAP_BYTES, 1);
         },
         [] {
             glPixelStorei(GL_PACK_ALIGNMENT, 4);
             glPixelStorei(GL_PACK_ROW_LENGTH, 0);
             glPixelStorei(GL_PACK_SKIP_ROWS, 0);
             glPixelStorei(GL_PACK_SWAP_BYTES, 0);
         }},
        {"pixel store, writing",
         [] {
             glPixelStorei(GL_UNPACK_ALIGNMENT, 8);
             glPixelStorei(GL_UNPACK_ROW_LENGTH, 1);
             glPixelStorei(GL_UNPACK_SKIP_PIXELS, 2);
             glPixelStorei(GL_UNPACK_SWAP_BYTES, 1);
         },
         [] {
             glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
             glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
             glPixelStorei(GL_UNPACK_SKIP_PIXELS, 0);
             glPixelStorei(GL_UNPACK_SWAP_BYTES, 0);
         }},
        {"pixel pack buffer", [&] { glBindBuffer(GL_PIXEL_PACK_BUFFER, host.buffer); },
         [] { glBindBuffer(GL_PIXEL_PACK_BUFFER, 0); }},
        {"pixel unpack buffer", [&] { glBindBuffer(GL_PIXEL_UNPACK_BUFFER, host.buffer); },
         [] { glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0); }},
        {"indirect buffers",
         [&] {
             glBindBuffer(GL_DRAW_INDIRECT_BUFFER, host.buffer);
             glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, host.buffer);
         },
         [] {
             glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
             glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, 0);
         }},
        {"storage buffers",
         [&] {
             for (GLuint i = 0; i < 16; ++i)
                 glBindBufferRange(GL_SHADER_STORAGE_BUFFER, i, host.buffer, 256 * i, 512);
             glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
         },
         [] {
             for (GLuint i = 0; i < 16; ++i)
                 glBindBufferBase(GL_SHADER_STORAGE_BUFFER, i, 0);
         }},
        {"uniform buffers",
         [&] {
             for (GLuint i = 0; i < 8; ++i)
                 glBindBufferBase(GL_UNIFORM_BUFFER, i, host.buffer);
         },
         [] {
             for (GLuint i = 0; i < 8; ++i)
                 glBindBufferBase(GL_UNIFORM_BUFFER, i, 0);
         }},
        {"samplers",
         [&] {
             for (GLuint i = 0; i < 32; ++i)
                 glBindSampler(i, host.sampler);
         },
         [] { glBindSamplers(0, 32, nullptr); }},
        {"textures",
         [&] {
             for (GLuint i = 0; i < 32; ++i)
                 for (const GLuint texture : host.textures)
                     glBindTextureUnit(i, texture);
             glActiveTexture(GL_TEXTURE7);
         },
         [] {
             glBindTextures(0, 32, nullptr);
             glActiveTexture(GL_TEXTURE0);
         }},
        {"images",
         [&] {
             for (GLuint i = 0; i < 8; ++i)
                 glBindImageTexture(i, host.textures[1], 0, GL_FALSE, 1, GL_READ_WRITE, GL_RGBA8);
         },
         [] { glBindImageTextures(0, 8, nullptr); }},
        {"vertex array and array buffer",
         [&] {
             glBindVertexArray(host.vertexArray);
             glBindBuffer(GL_ARRAY_BUFFER, host.buffer);
         },
         [] {
             glBindVertexArray(0);
             glBindBuffer(GL_ARRAY_BUFFER, 0);
         }},
        {"program", [&] { glUseProgram(host.program); }, [] { glUseProgram(0); }},
        {"framebuffers", [&] { glBindFramebuffer(GL_FRAMEBUFFER, host.framebuffer); },
         [] { glBindFramebuffer(GL_FRAMEBUFFER, 0); }},
        {"viewports",
         [] {
             for (GLuint i = 0; i < 16; ++i)
                 glViewportIndexedf(i, float(i), 2, 3.5f, 5);
         }},
        {"transform feedback",
         [&] {
             glUseProgram(host.program);
             glBindVertexArray(host.vertexArray);
             glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, host.buffer);
             glBeginTransformFeedback(GL_POINTS);
         },
         [] {
             glEndTransformFeedback();
             glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
             glUseProgram(0);
             glBindVertexArray(0);
         }},
    };
}

} // namespace limpid
