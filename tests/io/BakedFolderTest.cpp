#include "io/bake/BakedFolder.h"

#include <cmath>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/TempFolder.h"
#include "io/bake/BakeErrors.h"
#include "io/images/Images.h"

namespace limpid::io {
namespace {

using test::errorOf;
using test::TempFolder;
using testing::HasSubstr;

/// Two texels of 0.5 × 1 m on a floor seen from above: u along x, v along z, depth downward.
BakedMap floorMap(float left, float right) {
    BakedMap map;
    map.receiver = "floor";
    map.light = "sun";
    map.size = {2, 1};
    map.irradiance = {left, left, left, right, right, right};
    map.position = {0.25f, -1, 0.5f, 1, 0.75f, -1, 0.5f, 1};
    map.normal = {0, 1, 0, 0, 1, 0};
    map.worldToTexture = glm::dmat4({1, 0, 0, 0}, {0, 0, -10, 0}, {0, 1, 0, 0}, {0, 0, -9.5, 1});
    map.planesRequested = 5;
    map.planesDrawn = 1;
    map.deposited = 1.25;
    return map;
}

Bake bakeOf(std::vector<BakedMap> maps) {
    Bake bake;
    bake.device = "none";
    bake.input = "floor.toml";
    bake.method = "level-map";
    bake.time = 2.5;
    bake.lights = {{"sun", 8, 6, BakedFlux{3, 0.5, 0.25, 1.25, 0.5, 0.5, 0, 0.125}}};
    bake.maps = std::move(maps);
    return bake;
}

nlohmann::json readIndex(const std::filesystem::path& folder) {
    return nlohmann::json::parse(std::ifstream(folder / "index.json"));
}

TEST(BakedFolderTest, comesBackAsItWas) {
    const TempFolder folder;
    Bake bake = bakeOf({floorMap(1, 2), floorMap(3, 4)});
    bake.origin = {1e6, 0, 3};
    bake.maps[1].facing = 2;
    bake.maps[1].standardError = 0.001;
    writeBake(folder.path(), bake);
    const Bake read = readBake(folder.path());
    EXPECT_EQ(read.method, bake.method);
    EXPECT_EQ(read.time, bake.time);
    EXPECT_EQ(read.origin, bake.origin);
    ASSERT_EQ(read.lights.size(), 1u);
    EXPECT_EQ(read.lights[0].beams, 8);
    EXPECT_EQ(read.lights[0].beamsDrawn, 6);
    ASSERT_TRUE(read.lights[0].flux);
    EXPECT_EQ(read.lights[0].flux->rejected, 0.5);
    EXPECT_EQ(read.lights[0].flux->standardError, 0.125);
    ASSERT_EQ(read.maps.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(read.maps[i].receiver, "floor");
        EXPECT_EQ(read.maps[i].size, bake.maps[i].size);
        EXPECT_EQ(read.maps[i].irradiance, bake.maps[i].irradiance);
        EXPECT_EQ(read.maps[i].position, bake.maps[i].position);
        EXPECT_EQ(read.maps[i].normal, bake.maps[i].normal);
        EXPECT_EQ(read.maps[i].worldToTexture, bake.maps[i].worldToTexture);
        EXPECT_EQ(read.maps[i].facing, bake.maps[i].facing);
        EXPECT_EQ(read.maps[i].planesDrawn, 1);
        EXPECT_EQ(read.maps[i].deposited, 1.25);
        EXPECT_EQ(read.maps[i].standardError, bake.maps[i].standardError);
    }
}

TEST(BakedFolderTest, whatCannotBeWrittenLeavesTheOneBefore) {
    const TempFolder folder;
    const auto out = folder.path() / "maps";
    writeBake(out, bakeOf({floorMap(1, 2)}));
    Bake other = bakeOf({floorMap(3, 4), floorMap(5, 6)});
    other.maps[1].receiver = "wall";
    std::filesystem::create_directories(out / "wall.sun.normal.exr"); // in the way of its last map
    EXPECT_EQ(errorOf(folder, [&] { writeBake(out, other); }),
              "maps/wall.sun.normal.exr: cannot write: it is a folder");
    const Bake kept = readBake(out);
    ASSERT_EQ(kept.maps.size(), 1u);
    EXPECT_EQ(kept.maps[0].irradiance[3], 2);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(out), {}), 5) << "and nothing besides";
    std::filesystem::remove(out / "wall.sun.normal.exr");
    writeBake(out, other);
    EXPECT_EQ(readBake(out).maps[0].irradiance[3], 4);
}

TEST(BakedFolderTest, saysWhatIsWrongWithIt) {
    const TempFolder folder;
    const auto error = [&] { return errorOf(folder, [&] { readBake(folder.path()); }); };
    EXPECT_EQ(error(), "index.json: expected a file, found nothing of that name");
    folder.write("index.json", "{\n  \"maps\": oops }");
    EXPECT_EQ(error(), "index.json:2:11: expected JSON, found something else");
    folder.write("index.json", "{}");
    EXPECT_EQ(error(), "index.json: expected \"maps\", found none");
    folder.write("index.json", "[]");
    EXPECT_EQ(error(), "index.json: expected an object, found []");

    writeBake(folder.path(), bakeOf({floorMap(1, 2)}));
    const nlohmann::json good = readIndex(folder.path());
    const auto changed = [&](const char* pointer, const nlohmann::json& value) {
        nlohmann::json index = good;
        index[nlohmann::json::json_pointer(pointer)] = value;
        folder.write("index.json", index.dump());
        return error();
    };
    EXPECT_EQ(changed("/time", "noon"), "index.json.time: expected a number, found \"noon\"");
    EXPECT_EQ(changed("/origin", {1, 2}), "index.json.origin: expected a list of 3, found [1,2]");
    EXPECT_EQ(changed("/maps/0/size", {0, 1}),
              "index.json.maps[0].size[0]: expected a whole number from 1 to 65536, found 0");
    EXPECT_EQ(changed("/maps/0/receiver", 3), "index.json.maps[0].receiver: expected a text, found 3");
    EXPECT_EQ(changed("/maps/0/facing", 1e300),
              "index.json.maps[0].facing: expected a whole number from 0 to 2147483647, found 1e+300");
    EXPECT_THAT(changed("/maps/0/world_to_texture", std::vector<int>(16, 0)),
                HasSubstr("world_to_texture: expected an invertible matrix, found [0,0,"));
    EXPECT_EQ(changed("/maps/0/size", {2, 2}),
              "floor.sun.irradiance.exr: expected 2 x 2 pixels as in index.json, found 2 x 1");
    EXPECT_EQ(changed("/maps/0/irradiance", "lost.exr"),
              "lost.exr: expected a file, found nothing of that name");
    EXPECT_EQ(changed("/maps/0/irradiance", good["maps"][0]["position"]),
              "floor.sun.position.exr: expected channels R, G, B, found R, G, B, A");
}

TEST(BakeErrorsTest, compareWhereBothSeeTheReceiver) {
    Bake a = bakeOf({floorMap(1, 9)});
    const Bake b = bakeOf({floorMap(2, 3)});
    a.maps[0].position[7] = 0;
    const std::vector<MapPair> pairs = pairMaps(a, b, "A", "B");
    ASSERT_EQ(pairs.size(), 1u);
    EXPECT_EQ(pairs[0].mask, (std::vector<float>{1, 0}));
    EXPECT_EQ(pairs[0].unmatched, 1u);
    const ImageErrors errors = imageErrors(pairs[0].images());
    EXPECT_EQ(errors.pixels, 1u);
    EXPECT_DOUBLE_EQ(errors.nmae, 0.5);
}

// A face at slope 1 has √2 times the area of its footprint; flux weighs with it.
TEST(BakeErrorsTest, weighFluxByTheSurface) {
    Bake a = bakeOf({floorMap(1, 3)});
    Bake b = bakeOf({floorMap(1, 1)});
    b.maps[0].normal = {0, 1, 0, std::sqrt(0.5f), std::sqrt(0.5f), 0};
    const std::vector<MapPair> pairs = pairMaps(a, b, "A", "B");
    EXPECT_NEAR(pairs[0].area[0], 0.5, 1e-6);
    EXPECT_NEAR(pairs[0].area[1], 0.5 * std::sqrt(2.0), 1e-6);
    EXPECT_NEAR(imageErrors(pairs[0].images()).fluxRatio, (1 + 3 * std::sqrt(2.0)) / (1 + std::sqrt(2.0)),
                1e-6);
}

TEST(BakeErrorsTest, doNotDependOnTheUnitOfLight) {
    const Bake b = bakeOf({floorMap(2, 3)}), a = bakeOf({floorMap(1, 5)});
    Bake brightA = bakeOf({floorMap(64, 320)}), brightB = bakeOf({floorMap(128, 192)});
    const ImageErrors errors = imageErrors(pairMaps(a, b, "A", "B")[0].images());
    const ImageErrors bright = imageErrors(pairMaps(brightA, brightB, "A", "B")[0].images());
    EXPECT_GT(errors.luv, 1);
    EXPECT_DOUBLE_EQ(errors.luv, bright.luv);
    EXPECT_DOUBLE_EQ(errors.nmae, bright.nmae);
}

TEST(BakeErrorsTest, ofAllMapsAreOfAllTheirTexels) {
    Bake a = bakeOf({floorMap(1, 2), floorMap(3, 4)}), b = bakeOf({floorMap(1, 2), floorMap(3, 2)});
    a.maps[1].facing = b.maps[1].facing = 1;
    const ImageErrors errors = bakeErrors(a, b, "A", "B");
    EXPECT_EQ(errors.pixels, 4u);
    EXPECT_DOUBLE_EQ(errors.nmae, 2.0 / 8);
    EXPECT_EQ(errors.largest, 2);
    EXPECT_DOUBLE_EQ(errors.fluxRatio, 10.0 / 8);
}

TEST(BakeErrorsTest, knowWhatChanceMayMakeOfAllMaps) {
    Bake truth = bakeOf({floorMap(1, 2), floorMap(3, 6)});
    truth.maps[0].standardError = 0.01;
    EXPECT_FALSE(standardError(truth)) << "not of every map";
    truth.maps[1].standardError = 0.005;
    EXPECT_DOUBLE_EQ(standardError(truth).value(), (0.01 * 3 + 0.005 * 9) / 12);
}

TEST(BakeErrorsTest, askForTheSameMapsAndTexels) {
    const TempFolder folder;
    const Bake b = bakeOf({floorMap(1, 2)});
    const auto error = [&](const Bake& a) { return errorOf(folder, [&] { pairMaps(a, b, "A", "B"); }); };
    EXPECT_EQ(error(b), "no error");
    EXPECT_EQ(error(bakeOf({})), "A: expected a map of floor in sun as in B, found none");
    Bake more = bakeOf({floorMap(1, 2), floorMap(1, 2)});
    more.maps[1].facing = 3;
    EXPECT_EQ(error(more), "B: expected a map of floor in sun, facing 3 as in A, found none");
    Bake larger = b;
    larger.maps[0].size = {4, 2};
    EXPECT_EQ(error(larger), "A: floor in sun: expected 2 x 1 texels as in B, found 4 x 2");
    Bake moved = b;
    moved.maps[0].worldToTexture[3].x += 0.1;
    EXPECT_EQ(error(moved), "A: floor in sun: expected texels where B has them, found them 0.2 texels away");
    // A quantized file's.
    moved.maps[0].worldToTexture[3].x = b.maps[0].worldToTexture[3].x + 0.015;
    EXPECT_EQ(error(moved), "no error");
    moved.maps[0].worldToTexture[3].x = b.maps[0].worldToTexture[3].x + 0.1;
    // The same place counted from another origin.
    moved.origin.x = 0.1;
    EXPECT_EQ(error(moved), "no error");
}

} // namespace
} // namespace limpid::io
