// limpid-stress [COARSER [GRID]]: what becomes of the light of profiles/stress.toml, by method, and known
// truths: the tables of profiles/stress.md on stdout. See tools/stress.
#include <cstdio>
#include <cstdlib>

#include "core/Error.h"
#include "stress/Balance.h"
#include "stress/Truths.h"

namespace limpid {
namespace {

class Table : public StressTest {
  public:
    static void print(int coarser, int grid) {
        printHead("scene");
        for (const auto& [name, scene, more] : stress::stressScenes(coarser, grid)) {
            std::printf("| [%s](scenes/stress/%s.toml) |", name.c_str(), name.c_str());
            for (const Method method : allMethods())
                printBalance(name, scene, method);
            std::printf("\n");
            std::fflush(stdout);
        }
        std::printf("\n");
        for (const stress::Known& known : stress::allKnown())
            std::printf("- `%s`, %s: %s.\n", std::string(known.scene).c_str(),
                        std::string(known.methods).c_str(), std::string(known.why).c_str());
    }

    static void printTruths() {
        printHead("scene, and what it is held against");
        for (const stress::Truth& truth : stress::allTruths()) {
            std::printf("| %s: %s |", truth.name, truth.what);
            for (const Method method : allMethods()) {
                const double figure = truth.figure(engine(), method);
                std::printf(figure > truth.mostExactBeam ? " **%.2g** |" : " %.2g |", 100 * figure);
            }
            std::printf("\n");
            std::fflush(stdout);
        }
    }

  private:
    static void printHead(const char* first) {
        std::printf("| %s |", first);
        for (const Method method : allMethods())
            std::printf(" %s |", std::string(methodName(method)).c_str());
        std::printf("\n|");
        for (std::size_t i = 0; i <= allMethods().size(); ++i)
            std::printf(" --- |");
        std::printf("\n");
    }

    static void printBalance(const std::string& name, Scene scene, Method method) {
        scene.caustics.method = method;
        const Baked baked = bake(engine(), scene, true);
        expectLight(baked, name);
        const double residual = residualShare(baked);
        std::printf(std::abs(residual) > stress::mostResidual(method) ? " **%.3f** |" : " %.3f |",
                    100 * residual);
        std::fflush(stdout);
    }
};

} // namespace
} // namespace limpid

int main(int argc, char** argv) {
    try {
        std::printf("## Where the light goes\n");
        const int coarser = argc > 1 ? std::max(std::atoi(argv[1]), 1) : 1;
        const int grid = argc > 2 ? std::max(std::atoi(argv[2]), 8) : 1024;
        limpid::Table::print(coarser, grid);
        std::printf("\n## Known light\n");
        limpid::Table::printTruths();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "limpid-stress: %s\n", error.what());
        return 3;
    }
}
