// A texture with smaller levels, and a derivative, ask the neighbouring fragments. Where one of them has been
// discarded, the answer is undefined: a speck along waterlines and holes.

#include <map>
#include <regex>
#include <set>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "gl/ShaderLibrary.h"

namespace limpid::gl {
namespace {

/// Of every function of a shader, by its name.
std::map<std::string, std::string> bodies(const std::string& text) {
    const std::regex head(R"(\n\w+ (\w+)\([^()]*\) \{)");
    std::map<std::string, std::string> found;
    for (std::sregex_iterator at(text.begin(), text.end(), head), end; at != end; ++at) {
        const auto from = std::size_t(at->position() + at->length());
        // On one line, or up to a brace that begins one.
        const std::size_t line = text.find('\n', from);
        const bool isShort = line > from && text[line - 1] == '}';
        found[(*at)[1]] += text.substr(from, (isShort ? line : text.find("\n}", from)) - from);
    }
    return found;
}

/// A regular expression for what asks the neighbours, directly or through a function of `all`.
std::string asking(const std::map<std::string, std::string>& all) {
    // Textures of materials alone have smaller levels.
    std::string calls = R"((texture\(\w+Texture\b|dFd[xy]\(|fwidth\()";
    std::set<std::string> named;
    for (bool more = true; more;) {
        more = false;
        for (const auto& [name, body] : all)
            if (!named.contains(name) && std::regex_search(body, std::regex("\\b" + calls + ")"))) {
                calls += fmt::format("|{}\\(", name);
                named.insert(name);
                more = true;
            }
    }
    return "\\b" + calls + ")";
}

TEST(Discard, comesAfterAllThatAsksTheNeighbours) {
    int shaders = 0;
    for (const EmbeddedShader& shader : embeddedShaders()) {
        if (!shader.name.ends_with(".frag")) continue;
        const auto all = bodies(resolveShader(shader.name).text);
        ASSERT_TRUE(all.contains("main")) << shader.name;
        const std::string& main = all.at("main");
        const std::size_t first = main.find("discard;");
        if (first == std::string::npos) continue;
        ++shaders;
        const std::regex call(asking(all));
        std::smatch found;
        const std::string after = main.substr(first);
        EXPECT_FALSE(std::regex_search(after, found, call)) << shader.name << ": " << found.str();
    }
    EXPECT_GE(shaders, 8);
}

/// What stands behind || or && is asked by some of the neighbours only.
TEST(Discard, isDecidedByFragmentsTogether) {
    for (const EmbeddedShader& shader : embeddedShaders()) {
        if (!shader.name.ends_with(".frag")) continue;
        const auto all = bodies(resolveShader(shader.name).text);
        const std::regex call("(\\|\\||&&)[^;]*" + asking(all));
        for (const auto& [name, body] : all) {
            std::smatch found;
            if (name == "isHole") continue; // by a uniform
            EXPECT_FALSE(std::regex_search(body, found, call))
                << shader.name << ": " << name << ": " << found.str();
        }
    }
}

} // namespace
} // namespace limpid::gl
