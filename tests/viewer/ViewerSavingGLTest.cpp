// What the viewer saves is what it showed.
#include "apps/viewer/Gizmo.h"
#include "io/toml/SceneFile.h"
#include "viewer/ViewerFixture.h"

namespace limpid::test {
namespace {

using ViewerSavingGLTest = ViewerFixture;

TEST_F(ViewerSavingGLTest, aSavedSceneIsThePictureOfRender) {
    openPond();
    change("mousedown 1 mousemove 300 140 mousemove 260 120 mouseup 1", 0.3);
    change("key plus key plus click 4 key period key period", 0.3);
    const std::string text = saved();
    expectRendered(2.0 / 30);
    EXPECT_NE(text.find("[[receiver]]            # what it is about"), std::string::npos) << text;
}

TEST_F(ViewerSavingGLTest, aHandleMovesTheBallAndUndoBringsItBack) {
    const fs::path file = folder.write("pond.toml", pond);
    open(file.string(), {"--select", "ball"});
    ASSERT_TRUE(completes());
    // Where the interface puts things at this size, with letters of 11 pixels.
    const glm::dvec2 corner(202, 15), size(246, 303);
    Scene scene = io::loadScene(file);
    const viewer::Projection projection(scene.camera, scene.water, size);
    const viewer::Gizmo gizmo(scene.receivers[1], glm::dvec3(0), viewer::Gizmo::Mode::Move, projection, 55);
    const auto at = [&](double metres) {
        const glm::ivec2 pixel = glm::round(corner + *projection.pixel(gizmo.at(1, metres)));
        return fmt::format("mousemove {} {} ", pixel.x, pixel.y);
    };
    constexpr double from = 0.12, to = 0.27; // m over the middle
    display.send(at(from));
    // A handle under the mouse turns yellow.
    const auto isYellow = [&] {
        first = screen();
        for (int y = pictureFrom.y; y < pictureTo.y; ++y)
            for (int x = pictureFrom.x; x < pictureTo.x; ++x)
                if (first.at(x, y) == glm::ivec3(255, 225, 90)) return true;
        return false;
    };
    ASSERT_TRUE(until(isYellow));
    change("mousedown 1 " + at(0.5 * (from + to)) + at(to) + "mouseup 1", 0.02);
    saved();
    expectRendered(0);
    const Scene moved = io::loadScene(savedScene());
    const glm::dvec3 way = moved.receivers[1].translation - scene.receivers[1].translation;
    EXPECT_EQ(way.x, 0);
    EXPECT_EQ(way.z, 0);
    // A mouse stands on whole pixels, of 7 mm, which the height is foreshortened to by a half about.
    EXPECT_NEAR(way.y, to - from, 0.02);
    EXPECT_EQ(moved.receivers[0].translation, scene.receivers[0].translation);
    EXPECT_EQ(moved.camera.position, scene.camera.position);
    display.send(at(from) + "key ctrl+z");
    EXPECT_TRUE(until([&] { return pictureChange(first, screen()) == 0; }));
    change("key ctrl+y", 0.02);
}

TEST_F(ViewerSavingGLTest, everyKindOfSceneIsSavedAsItIsShown) {
    const std::string sea = "[water]\ngrid = [24, 24]\n[[water.wave]]\ntype = \"phillips\"\nmodes = 16\n"
                            "amplitude = 0.01\n";
    const std::string rain = "[water]\ngrid = [24, 24]\npreset = \"rain drops\"\nwave_scale = 3\n";
    const std::string depths =
        "[camera]\nposition = [0.9, -0.5, 1.6]\ntarget = [0, -0.3, 0]\n[godrays]\nmethod = \"photon-lines\"\n"
        "grid = [20, 20]\nscale = 0.5\n[water]\ngrid = [24, 24]\ntype = \"coastal\"\npreset = \"breeze\"\n";
    // Caustics of the start, for longer than the step of time below.
    const std::string objects =
        std::string(pond).substr(std::string(pond).find("[[light]]")) + "refresh = 10\n";
    for (const auto& [water, method] : {std::pair(sea, "level-map-smart"), std::pair(rain, "photon-splat"),
                                        std::pair(depths, "exact-beam")}) {
        SCOPED_TRACE(water);
        fs::remove(output());
        open(folder.write("pond.toml", water + objects).string(), {"--method", method});
        ASSERT_TRUE(completes());
        display.send("mousemove 322 250");
        change("click 4 key plus key period", 0.3);
        saved();
        expectRendered(1.0 / 30);
        TearDown();
    }
}

} // namespace
} // namespace limpid::test
