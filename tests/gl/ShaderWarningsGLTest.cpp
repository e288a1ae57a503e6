// The driver's words on shaders: none, whatever names of those that a shader asks for by #ifdef are defined.
// Mesa warns of a value that is read and was never written.
#include <cstdlib>

#include <fmt/ranges.h>
#include <gmock/gmock.h>

#include "core/Error.h"
#include "gl/GLFixture.h"
#include "gl/Program.h"
#include "gl/ShaderLibrary.h"
#include "gl/ShaderVariants.h"

namespace limpid::gl {
namespace {

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

TEST_F(ShaderWarningsGLTest, noneForAnyShaderAndItsVariants) {
    int variants = 0;
    for (const EmbeddedShader& shader : embeddedShaders()) {
        if (shader.name.ends_with(".glsl")) continue; // part of others
        for (const Names& defines : subsets(choices(resolveShader(shader.name).text))) {
            expectSilence(shader.name, defines);
            ++variants;
        }
    }
    EXPECT_GT(variants, 100);
}

} // namespace
} // namespace limpid::gl
