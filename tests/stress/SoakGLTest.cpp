#include "stress/Soak.h"

#include "gl/GLFixture.h"

namespace limpid {
namespace {

class SoakGLTest : public GLTest {};

// tools/soak does the same for longer, and watches the memory of the process too.
TEST_F(SoakGLTest, whatComesAndGoesLeavesNothingOnTheGpu) {
    const std::int64_t before = context().ledger().total();
    std::vector<std::int64_t> bytes;
    soak::run(context(), 15, 5, [&](const soak::Sample& sample) { bytes.push_back(sample.gpuBytes); });
    ASSERT_EQ(bytes.size(), 4u);
    // From the second on: passes that a method brings along are made when it comes first.
    EXPECT_EQ(bytes[2], bytes[3]);
    EXPECT_EQ(context().ledger().total(), before);
}

} // namespace
} // namespace limpid
