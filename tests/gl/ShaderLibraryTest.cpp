#include "gl/ShaderLibrary.h"

#include <gmock/gmock.h>

#include "core/Error.h"
#include "gl/Ledger.h"

namespace limpid::gl {
namespace {

using ::testing::HasSubstr;

TEST(ShaderLibrary, resolvesIncludesOnce) {
    const ResolvedShader shader = resolveShader("levelmap/level_map.frag");
    EXPECT_THAT(shader.text, HasSubstr("#version 450 core"));
    const std::string mark = "vec3 refractDirection(";
    const std::size_t first = shader.text.find(mark);
    ASSERT_NE(first, std::string::npos);
    EXPECT_EQ(shader.text.find(mark, first + 1), std::string::npos);
    EXPECT_EQ(shader.text.find("#include"), std::string::npos);
}

TEST(ShaderLibrary, namesFileAndLineInADriversMessage) {
    const ResolvedShader shader = resolveShader("water/beams.comp");
    const auto line =
        std::find(shader.origins.begin(), shader.origins.end(), "shaders/optics/optics.glsl:8");
    ASSERT_NE(line, shader.origins.end());
    const auto number = std::to_string(line - shader.origins.begin() + 1);
    EXPECT_EQ(shader.locate("0:" + number + "(3): error: bad"), "shaders/optics/optics.glsl:8: error: bad")
        << "Mesa";
    EXPECT_EQ(shader.locate("0(" + number + ") : error C1"), "shaders/optics/optics.glsl:8 : error C1")
        << "NVIDIA";
}

TEST(ShaderLibrary, saysWhichFileIsMissing) {
    try {
        resolveShader("water/none.comp");
        FAIL();
    } catch (const GraphicsError& error) {
        EXPECT_STREQ(error.what(),
                     "water/none.comp: expected a shader carried by the library, found none of that name");
    }
}

TEST(Ledger, countsByKind) {
    Ledger ledger;
    ledger.add("a", 100);
    ledger.add("b", 50);
    ledger.remove("a", 100);
    EXPECT_EQ(ledger.bytes("a"), 0);
    EXPECT_EQ(ledger.bytes("b"), 50);
    EXPECT_EQ(ledger.total(), 50);
    EXPECT_EQ(ledger.peak(), 150);
    ledger.resetPeak();
    EXPECT_EQ(ledger.peak(), 50);
    EXPECT_EQ(ledger.byKind().size(), 1u);
}

} // namespace
} // namespace limpid::gl
