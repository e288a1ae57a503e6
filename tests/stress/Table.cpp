// limpid-stress [COARSER [GRID [METHOD]…]]: what becomes of the light of profiles/stress.toml, by method, and
// known truths: the tables of profiles/stress.md on stdout. Leaves with 1 if a figure is beyond its bound,
// each named on stderr. See tools/stress.
#include <cstdio>
#include <cstdlib>

#include <fmt/format.h>

#include "core/Error.h"
#include "stress/Balance.h"
#include "stress/Truths.h"
#include "stress/Umbra.h"

namespace limpid {
namespace {

class Table : public StressTest {
  public:
    explicit Table(std::span<const Method> methods) : _methods(methods) {}

    /// What is beyond its bound, a line each.
    const std::vector<std::string>& missed() const { return _missed; }

    void print(int coarser, int grid) {
        printHead("scene", {"entering", "umbra", "give or take"});
        for (const stress::NamedScene& named : stress::stressScenes(coarser, grid)) {
            std::printf("| [%s](scenes/stress/%s.toml) |", named.name.c_str(), named.name.c_str());
            for (const Method method : _methods)
                printBalance(named, method);
            printTruth(named);
            std::printf("\n");
            std::fflush(stdout);
        }
        std::printf("\n");
        for (const stress::Known& known : stress::allKnown())
            std::printf("- `%s`, %s: %s.\n", std::string(known.scene).c_str(),
                        std::string(known.methods).c_str(), std::string(known.why).c_str());
    }

    void printTruths() {
        printHead("scene, and what it is held against");
        for (const stress::Truth& truth : stress::allTruths()) {
            std::printf("| %s: %s |", truth.name, truth.what);
            for (const Method method : _methods) {
                const double figure = truth.figure(engine(), method);
                require(truth.name, method, figure, truth.mostOf(method));
                std::printf(figure > truth.mostExactBeam ? " **%.2g** |" : " %.2g |", 100 * figure);
            }
            std::printf("\n");
            std::fflush(stdout);
        }
    }

  private:
    void TestBody() override {}

    void printHead(const char* first, std::initializer_list<const char*> last = {}) const {
        std::printf("| %s |", first);
        for (const Method method : _methods)
            std::printf(" %s |", std::string(methodName(method)).c_str());
        for (const char* column : last)
            std::printf(" %s |", column);
        std::printf("\n|");
        for (std::size_t i = 0; i <= _methods.size() + last.size(); ++i)
            std::printf(" --- |");
        std::printf("\n");
    }

    void require(const std::string& name, Method method, double figure, double most) {
        if (std::abs(figure) <= most) return;
        _missed.push_back(fmt::format("{} by {}: expected at most {:.3g} %, found {:.3g} %", name,
                                      methodName(method), 100 * most, 100 * figure));
    }

    void printBalance(const stress::NamedScene& named, Method method) {
        Scene scene = named.scene;
        scene.caustics.method = method;
        const Baked baked = bake(engine(), scene, true);
        expectLight(baked, named.name);
        const double residual = residualShare(baked);
        const stress::Known* known = stress::knownOf(named.name, method);
        require(named.name, method, residual,
                named.coarser * (known ? known->most : stress::mostResidual(method)));
        std::printf(std::abs(residual) > stress::mostResidual(method) ? " **%.3f** |" : " %.3f |",
                    100 * residual);
        std::fflush(stdout);
    }

    /// Exact beams against the reference, and the standard error of their balance.
    void printTruth(const stress::NamedScene& named) {
        Scene scene = named.scene;
        scene.caustics.method = Method::ExactBeam;
        const Baked baked = bake(engine(), scene, true);
        const stress::Umbra umbra(scene);
        const std::optional<double> light = umbra.light(baked);
        std::printf(" %.3f |", 100 * umbra.enteringError(baked));
        std::printf(light ? " %.3f |" : " – |", 100 * light.value_or(0));
        double error = 0, entering = 0;
        for (const FluxBalance& flux : baked.flux)
            error = std::hypot(error, flux.standardError), entering += flux.entering;
        std::printf(" %.3f |", entering > 0 ? 100 * error / entering : 0.0);
    }

    std::span<const Method> _methods;
    std::vector<std::string> _missed;
};

std::vector<Method> methodsNamed(std::span<char*> names) {
    std::vector<Method> methods;
    for (const char* name : names) {
        const auto method = methodFromName(name);
        if (!method) throw InputError(fmt::format("expected a method, found {}", name));
        methods.push_back(*method);
    }
    if (methods.empty()) methods.assign(allMethods().begin(), allMethods().end());
    return methods;
}

} // namespace
} // namespace limpid

int main(int argc, char** argv) {
    try {
        std::printf("## Where the light goes\n");
        const int coarser = argc > 1 ? std::max(std::atoi(argv[1]), 1) : 1;
        const int grid = argc > 2 ? std::max(std::atoi(argv[2]), 8) : 1024;
        const auto methods =
            limpid::methodsNamed(std::span(argv, std::size_t(argc)).subspan(std::min(argc, 3)));
        limpid::Table table(methods);
        table.print(coarser, grid);
        std::printf("\n## Known light\n");
        table.printTruths();
        for (const std::string& line : table.missed())
            std::fprintf(stderr, "limpid-stress: %s\n", line.c_str());
        // Of expectLight, which has said it where the table stands.
        const bool impossible = testing::UnitTest::GetInstance()->ad_hoc_test_result().Failed();
        if (impossible || !table.missed().empty()) return 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "limpid-stress: %s\n", error.what());
        return 3;
    }
}
