#include "Shaders.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace {

std::string readFile(const std::filesystem::path& file) {
    std::ifstream stream(file);
    if (!stream) throw std::runtime_error(file.string() + ": expected a shader, got no such file");
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::string sourceOf(const std::string& file) {
    std::string text = readFile(std::filesystem::path(OWN_SHADERS) / file);
    const std::string include = "#include \"limpid_caustics.glsl\"";
    if (const std::size_t at = text.find(include); at != std::string::npos)
        text.replace(at, include.size(),
                     readFile(std::filesystem::path(LIMPID_SHADERS) / "limpid_caustics.glsl"));
    return text;
}

GLuint compile(const std::string& file) {
    const GLenum stage = file.ends_with(".vert")   ? GL_VERTEX_SHADER
                         : file.ends_with(".frag") ? GL_FRAGMENT_SHADER
                                                   : GL_COMPUTE_SHADER;
    const GLuint shader = glCreateShader(stage);
    const std::string source = sourceOf(file);
    const char* text = source.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint done = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
    char log[4096] = "";
    glGetShaderInfoLog(shader, sizeof(log), nullptr, log);
    if (!done) throw std::runtime_error(file + ": " + log);
    return shader;
}

} // namespace

GLuint makeProgram(std::initializer_list<const char*> files) {
    const GLuint program = glCreateProgram();
    for (const char* file : files) {
        const GLuint shader = compile(file);
        glAttachShader(program, shader);
        glDeleteShader(shader);
    }
    glLinkProgram(program);
    GLint done = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &done);
    char log[4096] = "";
    glGetProgramInfoLog(program, sizeof(log), nullptr, log);
    if (!done) throw std::runtime_error(std::string(*files.begin()) + ": " + log);
    return program;
}
