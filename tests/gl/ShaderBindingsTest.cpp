// What passes bind and what shaders ask for go by the names of shaders/interface/bindings.glsl, on both
// sides: no number stands beside them, and no stage finds two things at one place.

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "Folders.h"
#include "gl/Bindings.h"
#include "gl/Context.h"
#include "gl/ShaderLibrary.h"

namespace limpid::gl {
namespace {

namespace fs = std::filesystem;

std::string textOf(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

/// "path: line" of every place below `folder` that `expression` matches.
std::vector<std::string> linesWith(const char* folder, const std::string& expression) {
    const std::regex regex(expression);
    std::vector<std::string> found;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(test::rootFolder()) / folder)) {
        if (!entry.is_regular_file()) continue;
        std::ifstream file(entry.path());
        for (std::string line; std::getline(file, line);)
            if (std::regex_search(line, regex))
                found.push_back(fmt::format("{}: {}", entry.path().filename().string(), line));
    }
    return found;
}

std::map<std::string, int> numbers() {
    const std::string text = textOf(fs::path(test::rootFolder()) / "shaders/interface/bindings.glsl");
    const std::regex constant(R"(const int (\w+) = (\d+);)");
    std::map<std::string, int> found;
    for (std::sregex_iterator at(text.begin(), text.end(), constant), end; at != end; ++at)
        found[(*at)[1]] = std::stoi((*at)[2]);
    return found;
}

TEST(ShaderBindings, areNamedOnBothSides) {
    using ::testing::IsEmpty;
    EXPECT_THAT(linesWith("shaders", R"(\b(binding|location)\s*=\s*\d)"), IsEmpty());
    EXPECT_THAT(linesWith("src", R"(\b(bind|bindStorage|bindUniform|bindImage|set|attribute)\(\d)"),
                IsEmpty());
    EXPECT_THAT(linesWith("src", R"(glBind(BufferBase|BufferRange|ImageTexture|TextureUnit)\((GL_\w+, )?\d)"),
                IsEmpty());
}

/// A name's last word says what it is bound as.
std::string kindOf(const std::string& name) {
    return name.substr(name.find_last_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ"));
}

TEST(ShaderBindings, leaveNoStageTwoThingsAtOnePlace) {
    const auto numbered = numbers();
    ASSERT_GT(numbered.size(), 150u);
    const std::regex use(
        R"((?:layout\([^)]*(?:binding|location) = |\n(?:UNIFORM|STORAGE)_BLOCK\(\w+, )(\w+)\))");
    for (const EmbeddedShader& shader : embeddedShaders()) {
        if (shader.name.ends_with(".glsl")) continue;
        const std::string text = resolveShader(shader.name).text;
        std::map<std::pair<std::string, int>, std::string> held;
        for (std::sregex_iterator at(text.begin(), text.end(), use), end; at != end; ++at) {
            const std::string name = (*at)[1];
            if (name == "at") continue; // of the macro itself
            ASSERT_TRUE(numbered.contains(name)) << shader.name << " asks for " << name;
            const auto& [place, first] = held.emplace(std::pair(kindOf(name), numbered.at(name)), name);
            EXPECT_EQ(place->second, name) << shader.name;
        }
    }
}

// What the context asks of a driver (gl/Context.cpp).
TEST(ShaderBindings, areAsManyBuffersAStageAsIsAskedFor) {
    const std::map<std::string, int> asked = {{"comp", computeBuffers},
                                              {"frag", fragmentBuffers},
                                              {"vert", vertexBuffers},
                                              {"geom", geometryBuffers}};
    std::map<std::string, int> most;
    const std::regex buffer(R"((?:binding = |STORAGE_BLOCK\(\w+, )(\w+Buffer)\))");
    for (const EmbeddedShader& shader : embeddedShaders()) {
        if (shader.name.ends_with(".glsl") || shader.name.starts_with("..")) continue;
        const std::string text = resolveShader(shader.name).text;
        const std::set<std::string> names(std::sregex_token_iterator(text.begin(), text.end(), buffer, 1),
                                          {});
        int& so = most[std::string(shader.name.substr(shader.name.rfind('.') + 1))];
        so = std::max(so, int(names.size()));
    }
    for (const auto& [stage, count] : most)
        EXPECT_EQ(count, asked.contains(stage) ? asked.at(stage) : 0) << stage;
    for (const auto& [name, number] : numbers())
        if (kindOf(name) == "Buffer") {
            EXPECT_LT(number, bufferBindings) << name;
        }
}

TEST(Devices, softwareWhereHardwareIsFoundIsToldOnce) {
    const DeviceDescription card{0, "/dev/dri/card0", false}, software{1, "software", true};
    const std::vector<DeviceDescription> both = {card, software}, alone = {software};
    EXPECT_EQ(
        softwareWord(both, "device 1 (software)"),
        "OpenGL: expected to open 0 (/dev/dri/card0), found no OpenGL 4.5 there: in software from here on");
    EXPECT_FALSE(softwareWord(both, "surfaceless").empty());
    EXPECT_EQ(softwareWord(both, "device 0 (/dev/dri/card0)"), "");
    EXPECT_EQ(softwareWord(alone, "device 1 (software)"), "");
}

TEST(ShaderBindings, giveEachUniformNumbersOfItsOwn) {
    std::map<int, std::string> held;
    for (const auto& [name, number] : numbers())
        if (kindOf(name) == "Location") {
            EXPECT_TRUE(held.emplace(number, name).second) << name << " and " << held.at(number);
        }
}

} // namespace
} // namespace limpid::gl
