// Traps and extremes, for every method: a balance of what enters and where it goes, light that is known, and
// no number in any output that light cannot have. tools/stress makes profiles/stress.md of the same at full
// size.
#include "stress/Balance.h"
#include "stress/Truths.h"

namespace limpid {
namespace {

class StressGLTest : public StressTest {};

void expectBalance(const Baked& baked, double residual, const stress::NamedScene& scene, Method method) {
    const std::string what = scene.name + " by " + std::string(methodName(method));
    const stress::Known* known = stress::knownOf(scene.name, method);
    const double most = known ? known->most : stress::mostResidual(method);
    EXPECT_LE(std::abs(residual), scene.coarser * most) << what;
    for (const FluxBalance& flux : baked.flux)
        EXPECT_LE(flux.deposited, 1.5 * flux.entering) << what;
}

TEST_F(StressGLTest, everyMethodAccountsForItsLight) {
    for (stress::NamedScene& named : stress::stressScenes(4, 128)) {
        Scene& scene = named.scene;
        const std::string& name = named.name;
        scene.caustics.photonGrid = {100, 100};
        // Many maps, or many lights.
        if (name == "along-light" || name == "emergent" || name == "lights") {
            scene.water.grid /= 2;
            named.coarser *= 2;
        }
        printf("%-14s", name.c_str());
        for (const Method method : allMethods()) {
            // Both have a level map's light bit for bit (SlicingEquivalenceGLTest, VolumetricGLTest).
            if (method == Method::LevelMapSmart || method == Method::Volumetric) continue;
            scene.caustics.method = method;
            const Baked baked = bake(scene, true);
            expectLight(baked, name + " by " + std::string(methodName(method)));
            EXPECT_EQ(impossible(engine().draw({32, 18}).rgb), 0u) << name;
            const double residual = residualShare(baked);
            expectBalance(baked, residual, named, method);
            printf(" %7.3f", 100 * residual);
        }
        printf("\n");
        fflush(stdout);
    }
}

TEST_F(StressGLTest, knownLight) {
    for (const stress::Truth& truth : stress::allTruths())
        for (const Method method : allMethods()) {
            const double most = truth.mostOf(method);
            EXPECT_LE(truth.figure(engine(), method), most) << truth.name << " by " << methodName(method);
        }
}

} // namespace
} // namespace limpid
