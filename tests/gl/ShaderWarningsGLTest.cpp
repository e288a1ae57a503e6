// The driver's words on shaders: none, whatever names of those that a shader asks for by #ifdef are defined.
// Mesa warns of a value that is read and was never written.
#include <cstdlib>
#include <regex>
#include <set>

#include <fmt/ranges.h>
#include <gmock/gmock.h>

#include "core/Error.h"
#include "gl/GLFixture.h"
#include "gl/Program.h"
#include "gl/ShaderLibrary.h"

namespace limpid::gl {
namespace {

using Names = std::vector<std::string>;

class ShaderWarningsGLTest : public GLTest {
  protected:
    /// A shader that is found in the cache is not compiled, and nothing is said of it.
    static void SetUpTestSuite() { setenv("MESA_SHADER_CACHE_DISABLE", "true", 1); }

    static void expectSilence(std::string_view shader, const Names& defines) {
        SCOPED_TRACE(fmt::format("{} {}", shader, defines));
        try {
            Program({std::string(shader).c_str()}, defines);
        } catch (const GraphicsError& error) { // a stage that cannot stand alone
            EXPECT_THAT(error.what(), ::testing::HasSubstr("does not link"));
        }
        EXPECT_THAT(messages(), ::testing::IsEmpty());
        messages().clear();
    }
};

std::set<std::string> found(const std::string& text, const char* expression) {
    const std::regex regex(expression);
    return {std::sregex_token_iterator(text.begin(), text.end(), regex, 1), std::sregex_token_iterator()};
}

/// Names in conditions, but for those that the text itself defines.
Names choices(const std::string& text) {
    std::set<std::string> names;
    for (const std::string& condition : found(text, R"(\n#if([^\n]*))"))
        names.merge(found(condition, R"(\b([A-Z_]{3,})\b)"));
    for (const std::string& own : found(text, R"(\n#define (\w+))"))
        names.erase(own);
    return {names.begin(), names.end()};
}

TEST_F(ShaderWarningsGLTest, noneForAnyShaderAndItsVariants) {
    int variants = 0;
    for (const EmbeddedShader& shader : embeddedShaders()) {
        if (shader.name.ends_with(".glsl")) continue; // part of others
        const Names names = choices(resolveShader(shader.name).text);
        for (unsigned choice = 0; choice < 1u << names.size(); ++choice, ++variants) {
            Names defines;
            for (std::size_t i = 0; i < names.size(); ++i)
                if (choice >> i & 1) defines.push_back(names[i]);
            expectSilence(shader.name, defines);
        }
    }
    EXPECT_GT(variants, 100);
}

} // namespace
} // namespace limpid::gl
