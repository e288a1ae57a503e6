#pragma once
#include <array>

#include <glm/glm.hpp>

#include "gl/Api.h"
#include "gl/Bindings.h"

namespace limpid::gl {

/// The state that a host has set in its context, of all that our passes read or change (but how pixels are
/// packed: gl/PixelTransfer.h). Made, it sets that of a fresh context; gone, the host's is back. Passes keep
/// to draw buffers 0 to 3, blend functions of 0 and 1, viewport, depth range and scissor box 0, texture
/// units, image units and binding points as below.
class HostState {
  public:
    HostState();
    ~HostState();
    HostState(const HostState&) = delete;
    HostState& operator=(const HostState&) = delete;

    static constexpr int textureUnits = 16, imageUnits = 3, storageBindings = bufferBindings,
                         uniformBindings = 3;

  private:
    static constexpr int capabilities = 34, blendedBuffers = 2, drawBuffers = 4,
                         bufferTargets = 4;

    struct Blend {
        std::array<GLint, 4> functions{GL_ONE, GL_ZERO, GL_ONE, GL_ZERO}; ///< colour, alpha: source, target
        std::array<GLint, 2> equations{GL_FUNC_ADD, GL_FUNC_ADD};
    };
    struct Stencil {
        GLint function = GL_ALWAYS, reference = 0;
        GLuint mask = ~0u;
        std::array<GLint, 3> operations{GL_KEEP, GL_KEEP, GL_KEEP};
        GLuint written = ~0u;
    };
    /// The numbers of a fresh context, or of the host's.
    struct Numbers {
        std::array<Blend, blendedBuffers> blends{};
        std::array<std::array<GLboolean, 4>, drawBuffers> written{};
        std::array<Stencil, 2> stencils{}; ///< front, back
        GLint frontFace = GL_CCW, polygonMode = GL_FILL, clipOrigin = GL_LOWER_LEFT,
              clipDepth = GL_NEGATIVE_ONE_TO_ONE, provoking = GL_LAST_VERTEX_CONVENTION, patch = 3,
              depthFunction = GL_LESS;
        GLboolean depthWritten = GL_TRUE;
        glm::dvec2 depthRange{0, 1};
    };
    /// A buffer at a binding point; `size` 0: all of it.
    struct Range {
        GLint buffer = 0;
        GLint64 start = 0, size = 0;
    };
    struct Unit {
        GLint plain = 0, layered = 0, sampler = 0;
    };
    struct Image {
        GLint texture = 0, level = 0, layered = 0, layer = 0, access = GL_READ_ONLY, format = GL_R8;
    };

    static Numbers fresh();
    static Numbers read();
    static void set(const Numbers& numbers);
    void readBindings();
    void setBindings() const;

    std::array<bool, capabilities> _on{};
    Numbers _numbers;
    glm::vec4 _viewport{0};
    glm::ivec4 _scissor{0};
    std::array<GLint, bufferTargets> _buffers{};
    std::array<Unit, textureUnits> _units{};
    std::array<Image, imageUnits> _images{};
    std::array<Range, storageBindings> _storage{};
    std::array<Range, uniformBindings> _uniform{};
    GLint _activeUnit = 0, _vertexArray = 0, _program = 0, _drawn = 0, _read = 0;
    bool _feedback = false; ///< a transform feedback that runs is paused
};

} // namespace limpid::gl
