// The same scene gives the same bits: twice, after other work in the same process, in another process.
#include "apps/RunProgram.h"
#include "io/TempFolder.h"
#include "scene/MethodFacts.h"
#include "stress/Soak.h"
#include "stress/StressFixture.h"

namespace limpid {
namespace {

class DeterminismGLTest : public StressTest {
  protected:
    struct Bits {
        std::vector<std::vector<float>> maps;
        std::vector<float> picture;
        bool operator==(const Bits&) const = default;
    };
    static Bits bits(Engine& engine, const Scene& scene) {
        const Baked baked = bake(engine, scene);
        Bits bits;
        for (const MapData& map : baked.maps)
            bits.maps.push_back(map.irradiance), bits.maps.push_back(map.position);
        bits.picture = engine.draw({32, 18}).rgb;
        return bits;
    }
};

// Drawing adds floats in the order of the triangles; all else sums in integers.
TEST_F(DeterminismGLTest, everyMethodTwiceAndAfterOtherWork) {
    for (const Method method : allMethods())
        for (const Fill fill : allFills()) {
            Scene scene = stressScene("objects", 48, 64);
            scene.caustics.method = method;
            scene.caustics.fill = fill;
            scene.caustics.photonGrid = {40, 40};
            if (fill == Fill::Drawn && !factsOf(method).fills) continue;
            Engine engine(context()), other(context());
            const Bits first = bits(engine, scene);
            const std::string what(methodName(method));
            EXPECT_TRUE(bits(engine, scene) == first) << what << ", the same engine";
            std::mt19937 random(3);
            for (int i = 0; i < 4; ++i)
                bits(engine, soak::anyScene(random));
            EXPECT_TRUE(bits(engine, scene) == first) << what << ", after other scenes";
            EXPECT_TRUE(bits(other, scene) == first) << what << ", another engine";
        }
}

TEST_F(DeterminismGLTest, theSameCommandTwice) {
    const test::TempFolder folder;
    const std::string scene = test::rootFolder() + "/profiles/scenes/stress/objects.toml";
    for (const char* name : {"one", "two"}) {
        const std::string quick =
            " --quiet --set water.grid=[48,48] --map-size 64 -o " + (folder.path() / name).string();
        ASSERT_EQ(test::run("bake " + scene + quick).code, 0);
        ASSERT_EQ(test::run("render " + scene + " --size 64x36" + quick + ".exr").code, 0);
    }
    EXPECT_EQ(test::run("compare --json " + (folder.path() / "one").string() + " " +
                        (folder.path() / "two").string() + " --max-nmae 0")
                  .code,
              0);
    const std::string path = folder.path().string();
    const std::string same =
        "diff -r " + path + "/one " + path + "/two && cmp " + path + "/one.exr " + path + "/two.exr";
    EXPECT_EQ(std::system(same.c_str()), 0);
}

} // namespace
} // namespace limpid
