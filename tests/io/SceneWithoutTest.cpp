#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/SmallGltf.h"
#include "io/TempFolder.h"
#include "io/toml/SceneFile.h"

namespace limpid::io {
namespace {

using test::errorOf;
using test::SmallGltf;
using test::TempFolder;
using test::triangleGltf;

/// A triangle "Basin", and "Water" high above it.
SmallGltf poolGltf() {
    SmallGltf gltf = triangleGltf();
    gltf.addMesh({{"attributes", {{"POSITION", 0}}}});
    gltf.json["nodes"][0]["name"] = "Basin";
    gltf.json["nodes"][1]["name"] = "Water";
    gltf.json["nodes"][1]["translation"] = {0, 9, 0};
    return gltf;
}

TEST(SceneWithoutTest, ReceiversLeaveOutWhatTheyAreTo) {
    const TempFolder folder;
    folder.write("pool.gltf", poolGltf().text());
    const std::string gltf = "[[receiver]]\ngltf = \"pool.gltf\"\n";
    const auto file = folder.write("scene.toml", gltf + gltf + "name = \"pool\"\nwithout = [\"Wat*\"]\n");
    Scene scene = loadScene(file);
    EXPECT_EQ(scene.receivers[0].mesh->triangleCount(), 2u);
    EXPECT_EQ(scene.receivers[1].mesh->triangleCount(), 1u);
    scene = loadScene(file, {{"receiver.pool.without", "[]"}, {"receiver.0.without", "[\"Basin\"]"}});
    EXPECT_EQ(worldBounds(scene.receivers[0]).min.y, 9);
    EXPECT_EQ(scene.receivers[1].mesh->triangleCount(), 2u);

    const auto errorWith = [&](const char* value) {
        return errorOf(folder, [&] { loadScene(file, {{"receiver.pool.without", value}}); });
    };
    for (const char* value : {"Water", "[1]", "[\"\"]"})
        EXPECT_THAT(
            errorWith(value),
            testing::HasSubstr(": expected a list of names or patterns, such as [\"Water*\"], found "))
            << value;
}

TEST(SceneWithoutTest, WhatIsLeftOutHasNoSayInTheScene) {
    const TempFolder folder;
    const auto file = folder.write("pool.glb", poolGltf().glb());
    const auto basin = folder.write("pool/pool.glb", triangleGltf().glb());
    const double level = loadScene(basin).water.level;
    EXPECT_GT(loadScene(file).water.level, 9);
    EXPECT_EQ(loadScene(file, {leavingOut({"Wat*", "Foam"})}).water.level, level);
    EXPECT_EQ(loadScene(file, {{"receiver.pool.without", "[\"Water\"]"}}).water.level, level);
    EXPECT_EQ(errorOf(folder,
                      [&] {
                          loadScene(file, {{"receiver.pool.without", "Water"}});
                      }),
              "--set receiver.pool.without=Water: expected a list of names or patterns, such as "
              "[\"Water*\"], found "
              "\"Water\"");
}

} // namespace
} // namespace limpid::io
