// A second front end on every shader: Khronos's glslangValidator, which follows the letter of the language
// where drivers are lenient. Programs are found in the sources, so that none can be left out.
#include <fstream>
#include <sstream>

#include <fmt/ranges.h>
#include <gmock/gmock.h>

#include "Folders.h"
#include "gl/ShaderLibrary.h"
#include "gl/ShaderVariants.h"
#include "io/TempFolder.h"

namespace limpid::gl {
namespace {

namespace fs = std::filesystem;

// Of a path's letters alone: std::regex takes a frame of the stack for each letter that it tries.
constexpr const char* drawing = R"re("([\w./]+\.(?:vert|tesc|tese|geom|frag))")re";

/// Text of all C++ sources of the library and its programs.
std::string sources() {
    std::ostringstream all;
    for (const fs::directory_entry& entry :
         fs::recursive_directory_iterator(fs::path(test::rootFolder()) / "src"))
        if (entry.path().extension() == ".cpp") all << std::ifstream(entry.path()).rdbuf();
    return all.str();
}

/// Shaders of each program that draws: the lists in the sources. Where a list has a variable, it is tried
/// with every fragment shader that the sources name outside of lists.
std::set<Names> drawingPrograms() {
    const std::string text = sources();
    const std::regex list(R"re(\{\s*"[\w./]+\.vert"[^{}]*\})re");
    const std::string others = std::regex_replace(text, list, "");
    std::set<Names> programs;
    for (std::sregex_iterator at(text.begin(), text.end(), list), end; at != end; ++at) {
        const std::set<std::string> named = found(at->str(), drawing);
        if (!std::regex_search(at->str(), std::regex(R"(,\s*[a-zA-Z_])"))) {
            programs.emplace(named.begin(), named.end());
            continue;
        }
        for (const std::string& fragment : found(others, R"re("([\w./]+\.frag)")re")) {
            Names files(named.begin(), named.end());
            files.push_back(fragment);
            programs.insert(files);
        }
    }
    return programs;
}

/// Shaders in a folder that glslangValidator is run over.
class Shaders {
  public:
    void write(const Names& files, const Names& defines) {
        for (const std::string& file : files) {
            const std::string name =
                fmt::format("{}{}", _written.size(), fs::path(file).extension().string());
            const ResolvedShader shader = resolveShader(file, defines);
            _written.emplace_back(_folder.write(name, shader.text), shader);
        }
    }
    /// What it says against them, with files and lines as they are in shaders/. `option` -l: that they link
    /// as well.
    std::string complaint(const std::string& option) const {
        const std::string command =
            fmt::format("glslangValidator {} {}/* 2>&1", option, _folder.path().string());
        FILE* pipe = popen(command.c_str(), "r");
        std::string said;
        for (char buffer[4096]; const std::size_t bytes = std::fread(buffer, 1, sizeof(buffer), pipe);)
            said.append(buffer, bytes);
        const int status = pclose(pipe);
        if (status == 0 && !std::regex_search(said, std::regex("ERROR|WARNING"))) return "";
        for (const auto& [file, shader] : _written)
            said = shader.locate(std::regex_replace(said, std::regex(file.string() + ":"), "0:"));
        return fmt::format("status {}: {}", status, said);
    }
    std::size_t size() const { return _written.size(); }

  private:
    test::TempFolder _folder;
    std::vector<std::pair<fs::path, ResolvedShader>> _written;
};

TEST(Glslang, acceptsEveryComputeShader) {
    Shaders shaders; // in one run: most of a run's time goes into the language's own functions
    for (const EmbeddedShader& shader : embeddedShaders())
        if (shader.name.ends_with(".comp"))
            for (const Names& defines : subsets(choices(resolveShader(shader.name).text)))
                shaders.write({std::string(shader.name)}, defines);
    EXPECT_EQ(shaders.complaint(""), "");
    EXPECT_GT(shaders.size(), 90u);
}

TEST(Glslang, acceptsEveryProgramThatDraws) {
    for (const Names& files : drawingPrograms()) {
        std::string all;
        for (const std::string& file : files)
            all += resolveShader(file).text;
        for (const Names& defines : subsets(choices(all))) {
            Shaders shaders;
            shaders.write(files, defines);
            EXPECT_EQ(shaders.complaint("-l"), "") << fmt::format("{} {}", files, defines);
        }
    }
}

TEST(Glslang, isAskedOfEveryShaderThatDraws) {
    std::set<std::string> asked;
    for (const Names& files : drawingPrograms())
        asked.insert(files.begin(), files.end());
    for (const EmbeddedShader& shader : embeddedShaders()) {
        const bool draws = !shader.name.ends_with(".glsl") && !shader.name.ends_with(".comp");
        if (draws && !shader.name.starts_with("..")) { // the benchmark's
            EXPECT_TRUE(asked.contains(std::string(shader.name))) << shader.name << " is part of no program";
        }
    }
}

TEST(Glslang, isHeardWhenItComplains) {
    Shaders shaders;
    shaders.write({"view/water.vert"}, {});
    shaders.write({"view/water.frag"}, {"vec3 vec2"});
    EXPECT_THAT(shaders.complaint(""), ::testing::HasSubstr("ERROR: shaders/"));
}

} // namespace
} // namespace limpid::gl
