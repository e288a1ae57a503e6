#include "gl/ShaderLibrary.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "core/Error.h"

namespace limpid::gl {

namespace {

std::string textOf(std::string_view name) {
    if (const auto folder = shaderFolder(); !folder.empty())
        if (std::ifstream file(folder / name); file) return {std::istreambuf_iterator<char>(file), {}};
    for (const EmbeddedShader& shader : embeddedShaders())
        if (shader.name == name) return std::string(shader.text);
    throw GraphicsError(
        fmt::format("{}: expected a shader carried by the library, found none of that name", name));
}

void append(ResolvedShader& shader, std::string_view line, std::string origin) {
    shader.text.append(line).push_back('\n');
    shader.origins.push_back(std::move(origin));
}

void appendFile(ResolvedShader& shader, std::string_view name, std::set<std::string, std::less<>>& done) {
    if (!done.emplace(name).second) return;
    std::istringstream text{textOf(name)};
    int number = 0;
    for (std::string line; std::getline(text, line);) {
        ++number;
        if (line.starts_with("#include \""))
            appendFile(shader, line.substr(10, line.rfind('"') - 10), done);
        else if (line != "#pragma once") // for C++, which reads some of them too
            append(shader, line, fmt::format("shaders/{}:{}", name, number));
    }
}

} // namespace

std::filesystem::path shaderFolder() {
    const char* folder = std::getenv("LIMPID_SHADERS");
    return folder ? folder : "";
}

ResolvedShader resolveShader(std::string_view name, std::span<const std::string> defines) {
    ResolvedShader shader;
    append(shader, "#version 450 core", "version");
    append(shader, "#define GLSL 1", "define");
    for (const std::string& define : defines)
        append(shader, "#define " + define, "define");
    std::set<std::string, std::less<>> done;
    appendFile(shader, name, done);
    return shader;
}

std::string ResolvedShader::locate(std::string_view compilerLog) const {
    // Mesa writes 0:12(3), NVIDIA 0(12), others 0:12.
    static const std::regex place(R"(\b0(?::(\d+)(?:\(\d+\))?|\((\d+)\)))");
    std::string out;
    const std::string log(compilerLog);
    auto from = log.cbegin();
    for (std::sregex_iterator match(log.begin(), log.end(), place), end; match != end; ++match) {
        const std::string number = (*match)[1].matched ? (*match)[1].str() : (*match)[2].str();
        const std::size_t line = std::stoul(number);
        out.append(from, (*match)[0].first);
        out += line >= 1 && line <= origins.size() ? origins[line - 1] : (*match)[0].str();
        from = (*match)[0].second;
    }
    return out.append(from, log.cend());
}

} // namespace limpid::gl
