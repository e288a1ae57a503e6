// The balance of exact beams in the scenes of profiles/stress.toml as they are, by the bar of the project and
// no exception. What takes longer than a few seconds, and the other methods: tools/stress 1 1024.
#include "stress/Balance.h"

namespace limpid {
namespace {

class FullSizeGLTest : public StressTest {};

/// Minutes of software GL, and a lens whose beams are exact by other tests.
constexpr std::string_view slow[] = {"along-light", "emergent", "lens", "lights"};

TEST_F(FullSizeGLTest, exactBeamsAccountForTheirLight) {
    for (const stress::NamedScene& named : stress::stressScenes(1, 1024)) {
        if (std::find(std::begin(slow), std::end(slow), named.name) != std::end(slow)) continue;
        if (stress::knownOf(named.name, Method::ExactBeam)) continue;
        ASSERT_EQ(named.scene.caustics.method, Method::ExactBeam) << named.name;
        const Baked baked = bake(engine(), named.scene, true);
        expectLight(baked, named.name);
        const double residual = residualShare(baked);
        printf("%-14s %7.3f\n", named.name.c_str(), 100 * residual);
        fflush(stdout);
        EXPECT_LE(std::abs(residual), stress::mostResidual(Method::ExactBeam)) << named.name;
    }
}

} // namespace
} // namespace limpid
