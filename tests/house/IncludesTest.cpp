// The rules of the house that a program can check: who may include whom, where OpenGL may appear, how long a
// file may be, and that no file names a place on its author's machine.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using Strings = std::vector<std::string>;

// Folder of src/ → the folders it may include besides itself and shaders/optics/ and shaders/interface/,
// whose pure functions and plain structs are everybody's. Downward only.
const std::map<std::string, Strings> mayInclude = {
    {"core", {}},
    {"gl", {"core"}},
    {"scene", {"core"}},
    {"plan", {"core", "scene"}},
    {"io", {"core", "scene"}},
    {"water", {"core", "gl", "scene", "plan"}},
    {"levelmap", {"core", "gl", "scene", "plan", "water"}},
    {"occlusion", {"core", "gl", "scene", "plan", "water", "levelmap"}},
    {"caustics", {"core", "gl", "scene", "plan", "water", "levelmap", "occlusion"}},
    {"godrays", {"core", "gl", "scene", "plan", "water", "levelmap"}},
    {"view", {"core", "gl", "scene", "plan", "water", "levelmap", "caustics"}},
    {"engine",
     {"core", "gl", "scene", "plan", "water", "levelmap", "occlusion", "caustics", "godrays", "view"}},
    {"limpid", {"core", "gl", "scene", "engine"}},
    {"reference", {"core", "scene", "plan", "io"}},
    {"audit", {"core", "gl", "scene", "plan", "water", "levelmap", "engine", "reference"}},
    {"apps",
     {"core", "gl", "scene", "plan", "io", "water", "levelmap", "occlusion", "caustics", "godrays", "view",
      "engine", "reference", "audit"}},
};

const Strings sourceFolders = {"src", "shaders", "tests", "examples", "models", "bench"};
const Strings codeFolders = {"src",   "shaders", "tests", "examples", "models",
                             "bench", "tools",   "cmake", ".ci"};
const Strings sourceExtensions = {".cpp",  ".h",    ".glsl", ".comp", ".vert",
                                  ".tesc", ".tese", ".geom", ".frag"};

constexpr std::size_t mostLines = 400;

bool contains(const Strings& list, const std::string& item) {
    return std::find(list.begin(), list.end(), item) != list.end();
}

/// A text file of the repository, its path relative to the root and its lines.
struct SourceFile {
    fs::path path;
    Strings lines;

    bool isSource() const { return contains(sourceExtensions, path.extension().string()); }
    bool isText() const {
        return path.extension() != ".glb" && path.extension() != ".exr" && path.extension() != ".png";
    }
};

SourceFile readFile(const fs::path& path) {
    SourceFile file{fs::relative(path, LIMPID_ROOT), {}};
    std::ifstream stream{path};
    for (std::string line; std::getline(stream, line);)
        file.lines.push_back(line);
    return file;
}

std::vector<SourceFile> filesOf(const Strings& folders) {
    std::vector<SourceFile> files;
    for (const std::string& folder : folders) {
        if (!fs::exists(fs::path{LIMPID_ROOT} / folder)) continue;
        for (const auto& entry : fs::recursive_directory_iterator{fs::path{LIMPID_ROOT} / folder})
            if (entry.is_regular_file()) files.push_back(readFile(entry.path()));
    }
    return files;
}

std::string listed(const Strings& lines) {
    return fmt::to_string(fmt::join(lines, "\n"));
}

/// "path:line: what", for each line that the rule objects to; the rule returns "" if it does not.
template <typename Rule>
void collect(const SourceFile& file, Strings& found, Rule&& rule) {
    for (std::size_t i = 0; i < file.lines.size(); ++i)
        if (const std::string what = rule(file.lines[i]); !what.empty())
            found.push_back(fmt::format("{}:{}: {}", file.path.string(), i + 1, what));
}

std::string judgeInclude(const std::string& folder, const std::string& line) {
    static const std::regex include{R"(^\s*#\s*include\s*"(?:([^/"]+)/)?[^"]*")"};
    std::smatch match;
    if (!std::regex_search(line, match, include)) return {};
    const std::string target = match[1].matched ? match[1].str() : folder;
    const auto allowed = mayInclude.find(folder);
    if (allowed == mayInclude.end())
        return fmt::format("src/{} is not in the table of IncludesTest.cpp", folder);
    if (target == folder || target == "optics" || target == "interface" || contains(allowed->second, target))
        return {};
    return fmt::format("src/{} may not include {}", folder, target);
}

TEST(Includes, goDownwardOnly) {
    Strings found;
    for (const SourceFile& file : filesOf({"src"})) {
        const std::string folder = (++file.path.begin())->string();
        collect(file, found, [&](const std::string& line) { return judgeInclude(folder, line); });
    }
    EXPECT_EQ(listed(found), "");
}

TEST(Includes, areJudgedByTheTable) {
    EXPECT_EQ(judgeInclude("water", "#include \"gl/Handles.h\""), "");
    EXPECT_EQ(judgeInclude("water", "#include \"Beams.h\""), "");
    EXPECT_EQ(judgeInclude("core", "#include \"optics/optics.glsl\""), "");
    EXPECT_EQ(judgeInclude("core", "#include <vector>"), "");
    EXPECT_EQ(judgeInclude("engine", "  # include \"io/images/Images.h\""), "src/engine may not include io");
    EXPECT_EQ(judgeInclude("attic", "#include \"core/Error.h\""),
              "src/attic is not in the table of IncludesTest.cpp");
}

TEST(Includes, inIoGoFromTradesToWhatTheyShare) {
    // Folder of src/io/ → the others that it may include; what they share, at the top, is everybody's.
    const std::map<std::string, Strings> trades = {
        {"io", {}}, {"images", {}}, {"gltf", {}}, {"bake", {"images"}}, {"toml", {"gltf", "images"}}};
    static const std::regex include{R"(^\s*#\s*include\s*"io/([^/"]+)/)"};
    Strings found;
    for (const SourceFile& file : filesOf({"src/io"})) {
        const fs::path below = file.path.lexically_relative("src/io").parent_path();
        const std::string folder = below.empty() ? "io" : below.begin()->string();
        collect(file, found, [&](const std::string& line) {
            std::smatch match;
            if (!std::regex_search(line, match, include)) return std::string{};
            const std::string target = match[1].str();
            if (target == folder || contains(trades.at(folder), target)) return std::string{};
            return fmt::format("{} may not include io/{}", folder, target);
        });
    }
    EXPECT_EQ(listed(found), "");
}

TEST(Includes, nameOpenGlHeadersOnlyInGl) {
    static const std::regex header{R"(^\s*#\s*include\s*[<"](epoxy|EGL|GL|GLES\d?|KHR)/)"};
    Strings found;
    for (const SourceFile& file : filesOf({"src", "tests", "models", "bench"}))
        if (file.path.parent_path() != "src/gl")
            collect(file, found, [](const std::string& line) {
                return std::regex_search(line, header) ? fmt::format("include gl/Api.h instead of {}", line)
                                                       : "";
            });
    EXPECT_EQ(listed(found), "");
}

TEST(Files, areShortEnoughToRead) {
    Strings found;
    for (const SourceFile& file : filesOf(sourceFolders))
        if (file.isSource() && file.lines.size() > mostLines)
            found.push_back(fmt::format("{}: {} lines, expected at most {}", file.path.string(),
                                        file.lines.size(), mostLines));
    EXPECT_EQ(listed(found), "");
}

TEST(Files, nameNoPlaceOfTheirAuthors) {
    static const std::regex place{R"((^|[^\w.)\]}/])/(work|home)/)"};
    Strings found;
    for (const SourceFile& file : filesOf(codeFolders))
        if (file.isText())
            collect(file, found, [](const std::string& line) {
                return std::regex_search(line, place) ? line : std::string{};
            });
    EXPECT_EQ(listed(found), "");
}

} // namespace
