#pragma once
#include <array>
#include <map>
#include <string>
#include <vector>

#include "gl/Api.h"

namespace limpid {

/// Everything that the driver tells of the state of a context by number, name by name.
using StateDump = std::map<std::string, std::vector<double>>;

inline StateDump dumpState() {
    struct Named {
        const char* name;
        GLenum value;
        int count = 1;
    };
#define NAMED(name)                                                                                          \
    { #name, name }
    static constexpr Named capabilities[] = {NAMED(GL_CULL_FACE),
                                             NAMED(GL_STENCIL_TEST),
                                             NAMED(GL_DEPTH_TEST),
                                             NAMED(GL_DEPTH_CLAMP),
                                             NAMED(GL_RASTERIZER_DISCARD),
                                             NAMED(GL_POLYGON_OFFSET_FILL),
                                             NAMED(GL_POLYGON_OFFSET_LINE),
                                             NAMED(GL_POLYGON_OFFSET_POINT),
                                             NAMED(GL_POLYGON_SMOOTH),
                                             NAMED(GL_PRIMITIVE_RESTART),
                                             NAMED(GL_PRIMITIVE_RESTART_FIXED_INDEX),
                                             NAMED(GL_SAMPLE_MASK),
                                             NAMED(GL_SAMPLE_COVERAGE),
                                             NAMED(GL_SAMPLE_ALPHA_TO_COVERAGE),
                                             NAMED(GL_SAMPLE_ALPHA_TO_ONE),
                                             NAMED(GL_SAMPLE_SHADING),
                                             NAMED(GL_MULTISAMPLE),
                                             NAMED(GL_COLOR_LOGIC_OP),
                                             NAMED(GL_FRAMEBUFFER_SRGB),
                                             NAMED(GL_PROGRAM_POINT_SIZE),
                                             NAMED(GL_LINE_SMOOTH),
                                             NAMED(GL_DITHER),
                                             NAMED(GL_TEXTURE_CUBE_MAP_SEAMLESS),
                                             NAMED(GL_CLIP_DISTANCE0),
                                             NAMED(GL_CLIP_DISTANCE5)};
    static constexpr Named numbers[] = {NAMED(GL_CULL_FACE_MODE),
                                        NAMED(GL_FRONT_FACE),
                                        {"GL_POLYGON_MODE", GL_POLYGON_MODE, 2},
                                        NAMED(GL_CLIP_ORIGIN),
                                        NAMED(GL_CLIP_DEPTH_MODE),
                                        NAMED(GL_PROVOKING_VERTEX),
                                        NAMED(GL_PATCH_VERTICES),
                                        NAMED(GL_PRIMITIVE_RESTART_INDEX),
                                        NAMED(GL_POLYGON_OFFSET_FACTOR),
                                        NAMED(GL_POLYGON_OFFSET_UNITS),
                                        NAMED(GL_MIN_SAMPLE_SHADING_VALUE),
                                        NAMED(GL_SAMPLE_COVERAGE_VALUE),
                                        NAMED(GL_SAMPLE_COVERAGE_INVERT),
                                        NAMED(GL_LINE_WIDTH),
                                        NAMED(GL_POINT_SIZE),
                                        {"GL_BLEND_COLOR", GL_BLEND_COLOR, 4},
                                        {"GL_COLOR_CLEAR_VALUE", GL_COLOR_CLEAR_VALUE, 4},
                                        NAMED(GL_DEPTH_CLEAR_VALUE),
                                        NAMED(GL_STENCIL_CLEAR_VALUE),
                                        NAMED(GL_DEPTH_FUNC),
                                        NAMED(GL_DEPTH_WRITEMASK),
                                        NAMED(GL_LOGIC_OP_MODE),
                                        NAMED(GL_STENCIL_FUNC),
                                        NAMED(GL_STENCIL_REF),
                                        NAMED(GL_STENCIL_VALUE_MASK),
                                        NAMED(GL_STENCIL_FAIL),
                                        NAMED(GL_STENCIL_PASS_DEPTH_FAIL),
                                        NAMED(GL_STENCIL_PASS_DEPTH_PASS),
                                        NAMED(GL_STENCIL_WRITEMASK),
                                        NAMED(GL_STENCIL_BACK_FUNC),
                                        NAMED(GL_STENCIL_BACK_REF),
                                        NAMED(GL_STENCIL_BACK_VALUE_MASK),
                                        NAMED(GL_STENCIL_BACK_FAIL),
                                        NAMED(GL_STENCIL_BACK_PASS_DEPTH_FAIL),
                                        NAMED(GL_STENCIL_BACK_PASS_DEPTH_PASS),
                                        NAMED(GL_STENCIL_BACK_WRITEMASK),
                                        NAMED(GL_PACK_SWAP_BYTES),
                                        NAMED(GL_PACK_LSB_FIRST),
                                        NAMED(GL_PACK_ROW_LENGTH),
                                        NAMED(GL_PACK_IMAGE_HEIGHT),
                                        NAMED(GL_PACK_SKIP_ROWS),
                                        NAMED(GL_PACK_SKIP_PIXELS),
                                        NAMED(GL_PACK_SKIP_IMAGES),
                                        NAMED(GL_PACK_ALIGNMENT),
                                        NAMED(GL_UNPACK_SWAP_BYTES),
                                        NAMED(GL_UNPACK_LSB_FIRST),
                                        NAMED(GL_UNPACK_ROW_LENGTH),
                                        NAMED(GL_UNPACK_IMAGE_HEIGHT),
                                        NAMED(GL_UNPACK_SKIP_ROWS),
                                        NAMED(GL_UNPACK_SKIP_PIXELS),
                                        NAMED(GL_UNPACK_SKIP_IMAGES),
                                        NAMED(GL_UNPACK_ALIGNMENT),
                                        NAMED(GL_PIXEL_PACK_BUFFER_BINDING),
                                        NAMED(GL_PIXEL_UNPACK_BUFFER_BINDING),
                                        NAMED(GL_ARRAY_BUFFER_BINDING),
                                        NAMED(GL_DRAW_INDIRECT_BUFFER_BINDING),
                                        NAMED(GL_DISPATCH_INDIRECT_BUFFER_BINDING),
                                        NAMED(GL_SHADER_STORAGE_BUFFER_BINDING),
                                        NAMED(GL_UNIFORM_BUFFER_BINDING),
                                        NAMED(GL_TRANSFORM_FEEDBACK_BUFFER_BINDING),
                                        NAMED(GL_ACTIVE_TEXTURE),
                                        NAMED(GL_VERTEX_ARRAY_BINDING),
                                        NAMED(GL_CURRENT_PROGRAM),
                                        NAMED(GL_PROGRAM_PIPELINE_BINDING),
                                        NAMED(GL_DRAW_FRAMEBUFFER_BINDING),
                                        NAMED(GL_READ_FRAMEBUFFER_BINDING),
                                        NAMED(GL_TRANSFORM_FEEDBACK_ACTIVE),
                                        NAMED(GL_TRANSFORM_FEEDBACK_PAUSED)};
    static constexpr Named ofDrawBuffers[] = {NAMED(GL_BLEND_SRC_RGB),
                                              NAMED(GL_BLEND_DST_RGB),
                                              NAMED(GL_BLEND_SRC_ALPHA),
                                              NAMED(GL_BLEND_DST_ALPHA),
                                              NAMED(GL_BLEND_EQUATION_RGB),
                                              NAMED(GL_BLEND_EQUATION_ALPHA),
                                              {"GL_COLOR_WRITEMASK", GL_COLOR_WRITEMASK, 4}};
    static constexpr Named ofViewports[] = {{"GL_VIEWPORT", GL_VIEWPORT, 4},
                                            {"GL_DEPTH_RANGE", GL_DEPTH_RANGE, 2},
                                            {"GL_SCISSOR_BOX", GL_SCISSOR_BOX, 4}};
    static constexpr Named ofUnits[] = {
        NAMED(GL_TEXTURE_BINDING_2D),        NAMED(GL_TEXTURE_BINDING_2D_ARRAY),
        NAMED(GL_TEXTURE_BINDING_3D),        NAMED(GL_TEXTURE_BINDING_CUBE_MAP),
        NAMED(GL_TEXTURE_BINDING_1D),        NAMED(GL_TEXTURE_BINDING_BUFFER),
        NAMED(GL_TEXTURE_BINDING_RECTANGLE), NAMED(GL_SAMPLER_BINDING)};
    static constexpr Named ofImages[] = {NAMED(GL_IMAGE_BINDING_NAME),    NAMED(GL_IMAGE_BINDING_LEVEL),
                                         NAMED(GL_IMAGE_BINDING_LAYERED), NAMED(GL_IMAGE_BINDING_LAYER),
                                         NAMED(GL_IMAGE_BINDING_ACCESS),  NAMED(GL_IMAGE_BINDING_FORMAT)};
    static constexpr Named ofStorage[] = {NAMED(GL_SHADER_STORAGE_BUFFER_BINDING),
                                          NAMED(GL_SHADER_STORAGE_BUFFER_START),
                                          NAMED(GL_SHADER_STORAGE_BUFFER_SIZE)};
    static constexpr Named ofUniform[] = {NAMED(GL_UNIFORM_BUFFER_BINDING), NAMED(GL_UNIFORM_BUFFER_START),
                                          NAMED(GL_UNIFORM_BUFFER_SIZE)};
#undef NAMED
    StateDump dump;
    for (const Named& n : capabilities)
        dump[n.name] = {double(glIsEnabled(n.value))};
    for (const Named& n : numbers) {
        std::vector<double> values(4);
        glGetDoublev(n.value, values.data());
        values.resize(std::size_t(n.count));
        dump[n.name] = values;
    }
    const auto indexed = [&](const auto& table, GLuint count) {
        for (const Named& n : table)
            for (GLuint i = 0; i < count; ++i) {
                std::vector<double> values(4);
                glGetDoublei_v(n.value, i, values.data());
                values.resize(std::size_t(n.count));
                dump[n.name + (" " + std::to_string(i))] = values;
            }
    };
    indexed(ofDrawBuffers, 8);
    for (GLuint i = 0; i < 8; ++i)
        dump["GL_BLEND " + std::to_string(i)] = {double(glIsEnabledi(GL_BLEND, i))};
    indexed(ofViewports, 16);
    for (GLuint i = 0; i < 16; ++i)
        dump["GL_SCISSOR_TEST " + std::to_string(i)] = {double(glIsEnabledi(GL_SCISSOR_TEST, i))};
    const GLint active = [] {
        GLint unit = 0;
        glGetIntegerv(GL_ACTIVE_TEXTURE, &unit);
        return unit;
    }();
    for (GLuint i = 0; i < 32; ++i) {
        glActiveTexture(GL_TEXTURE0 + i);
        for (const Named& n : ofUnits) {
            double value = 0;
            glGetDoublev(n.value, &value);
            dump[n.name + (" " + std::to_string(i))] = {value};
        }
    }
    glActiveTexture(GLenum(active));
    const auto indexedIntegers = [&](const auto& table, GLuint count) {
        for (const Named& n : table)
            for (GLuint i = 0; i < count; ++i) {
                GLint64 value = 0;
                glGetInteger64i_v(n.value, i, &value);
                dump[n.name + (" " + std::to_string(i))] = {double(value)};
            }
    };
    indexedIntegers(ofImages, 8);
    indexedIntegers(ofStorage, 16);
    indexedIntegers(ofUniform, 16);
    GLint mask = 0;
    glGetIntegeri_v(GL_SAMPLE_MASK_VALUE, 0, &mask);
    dump["GL_SAMPLE_MASK_VALUE"] = {double(mask)};
    return dump;
}

} // namespace limpid
