#pragma once
#include <bitset>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <utility>

#include <glm/glm.hpp>

#include "gl/Api.h"
#include "gl/Bindings.h"
#include "gl/Handles.h"

namespace limpid::gl {

/// A linked program of shaders from shaders/; the file's suffix says its stage (.vert .tesc .tese .geom .frag
/// .comp). Uniforms are set by the location that gl/Bindings.h and the shader name alike.
/// Throws GraphicsError with file and line when one does not compile or link.
class Program {
  public:
    Program() = default;
    explicit Program(std::initializer_list<const char*> files, std::span<const std::string> defines = {});
    ~Program() {
        if (_id) glDeleteProgram(_id);
    }
    Program(Program&& other) noexcept : _id(std::exchange(other._id, 0)), _unused(other._unused) {}
    Program& operator=(Program&& other) noexcept {
        std::swap(_id, other._id);
        std::swap(_unused, other._unused);
        return *this;
    }

    void use() const { glUseProgram(_id); }
    void set(GLint location, int value) const { glProgramUniform1i(_id, at(location), value); }
    void set(GLint location, float value) const { glProgramUniform1f(_id, at(location), value); }
    void set(GLint location, glm::uvec2 value) const { glProgramUniform2uiv(_id, at(location), 1, &value.x); }
    void set(GLint location, glm::ivec2 value) const { glProgramUniform2iv(_id, at(location), 1, &value.x); }
    void set(GLint location, glm::vec2 value) const { glProgramUniform2fv(_id, at(location), 1, &value.x); }
    void set(GLint location, glm::vec3 value) const { glProgramUniform3fv(_id, at(location), 1, &value.x); }
    void set(GLint location, glm::vec4 value) const { glProgramUniform4fv(_id, at(location), 1, &value.x); }
    void set(GLint location, const glm::mat4& value) const {
        glProgramUniformMatrix4fv(_id, at(location), 1, GL_FALSE, &value[0].x);
    }

    /// Runs a compute program over at least `items` invocations in groups of `groupSize` (as the shader has
    /// it).
    void dispatch(std::int64_t items, int groupSize) const;
    /// Groups by x, y and z as `buffer` has them at `offset` bytes, three 32-bit numbers.
    void dispatchIndirect(const Buffer& buffer, std::int64_t offset) const;
    void dispatch2D(glm::ivec2 items, glm::ivec2 groupSize) const;

  private:
    GLint at(GLint location) const { return _unused[std::size_t(location)] ? -1 : location; }
    GLuint _id = 0;
    /// Locations without a uniform, for shaders that are being worked on (gl/ShaderLibrary.h); in others,
    /// setting one that does not exist is the error that it is.
    std::bitset<uniformCount> _unused;
};

} // namespace limpid::gl
