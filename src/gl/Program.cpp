#include "gl/Program.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "core/Error.h"
#include "gl/Reset.h"
#include "gl/ShaderLibrary.h"

namespace limpid::gl {

namespace {

GLenum stageOf(std::string_view file) {
    constexpr std::pair<std::string_view, GLenum> stages[] = {
        {".vert", GL_VERTEX_SHADER},          {".tesc", GL_TESS_CONTROL_SHADER},
        {".tese", GL_TESS_EVALUATION_SHADER}, {".geom", GL_GEOMETRY_SHADER},
        {".frag", GL_FRAGMENT_SHADER},        {".comp", GL_COMPUTE_SHADER}};
    for (const auto& [suffix, stage] : stages)
        if (file.ends_with(suffix)) return stage;
    throw GraphicsError(fmt::format("{}: expected a suffix that names a shader stage", file));
}

/// Driver logs end in newlines and can be long; the first complaint is the one that matters.
std::string firstLines(std::string log) {
    while (!log.empty() && (log.back() == '\n' || log.back() == '\0'))
        log.pop_back();
    return log.substr(0, 1000);
}

std::bitset<uniformCount> unusedLocations(GLuint program) {
    std::bitset<uniformCount> unused;
    unused.set();
    GLint count = 0;
    glGetProgramInterfaceiv(program, GL_UNIFORM, GL_ACTIVE_RESOURCES, &count);
    for (GLint i = 0; i < count; ++i) {
        constexpr GLenum asked[] = {GL_LOCATION, GL_ARRAY_SIZE};
        GLint found[2] = {-1, 0}; // elements of an array have a location each
        glGetProgramResourceiv(program, GL_UNIFORM, GLuint(i), 2, asked, 2, nullptr, found);
        for (GLint at = found[0]; at >= 0 && at < std::min(found[0] + found[1], uniformCount); ++at)
            unused.reset(std::size_t(at));
    }
    return unused;
}

GLuint compile(const char* file, std::span<const std::string> defines) {
    const ResolvedShader source = resolveShader(file, defines);
    const GLuint shader = glCreateShader(stageOf(file));
    const char* text = source.text.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint ok = 0, length = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    if (ok) return shader;
    glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::string log(std::size_t(std::max(length, 1)), '\0');
    glGetShaderInfoLog(shader, length, nullptr, log.data());
    glDeleteShader(shader);
    requireContext();
    throw GraphicsError(
        fmt::format("shaders/{}: does not compile: {}", file, source.locate(firstLines(log))));
}

} // namespace

Program::Program(std::initializer_list<const char*> files, std::span<const std::string> defines) {
    _id = glCreateProgram();
    std::vector<GLuint> shaders;
    std::string label;
    for (const char* file : files) {
        shaders.push_back(compile(file, defines));
        glAttachShader(_id, shaders.back());
        label = file;
    }
    glObjectLabel(GL_PROGRAM, _id, -1, label.c_str());
    glLinkProgram(_id);
    for (const GLuint shader : shaders)
        glDeleteShader(shader);
    GLint ok = 0, length = 0;
    glGetProgramiv(_id, GL_LINK_STATUS, &ok);
    if (ok && !shaderFolder().empty()) _unused = unusedLocations(_id);
    if (ok) return;
    glGetProgramiv(_id, GL_INFO_LOG_LENGTH, &length);
    std::string log(std::size_t(std::max(length, 1)), '\0');
    glGetProgramInfoLog(_id, length, nullptr, log.data());
    requireContext();
    throw GraphicsError(fmt::format("shaders/{}: does not link: {}", label, firstLines(log)));
}

void Program::dispatch(std::int64_t items, int groupSize) const {
    assert(_id != 0 && groupSize >= 1);
    if (items <= 0) return;
    use();
    // A row of groups is at most 65,535 long; shaders flatten (x, y) back and check against the count.
    const std::int64_t groups = (items + groupSize - 1) / groupSize;
    const std::int64_t rows = (groups + 65534) / 65535;
    glDispatchCompute(GLuint((groups + rows - 1) / rows), GLuint(rows), 1);
}

void Program::dispatchIndirect(const Buffer& buffer, std::int64_t offset) const {
    assert(_id != 0 && offset % 4 == 0 && offset + 12 <= buffer.bytes());
    use();
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, buffer.id());
    glDispatchComputeIndirect(GLintptr(offset));
}

void Program::dispatch2D(glm::ivec2 items, glm::ivec2 groupSize) const {
    if (items.x <= 0 || items.y <= 0) return;
    use();
    const glm::ivec2 groups = (items + groupSize - 1) / groupSize;
    glDispatchCompute(GLuint(groups.x), GLuint(groups.y), 1);
}

} // namespace limpid::gl
