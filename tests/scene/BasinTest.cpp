// Which meshes hold water, and up to where.
#include "scene/Basin.h"
#include "Folders.h"

#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "io/gltf/Gltf.h"
#include "scene/MeshBuilder.h"
#include "scene/Shapes.h"

namespace limpid {
namespace {

using Builder = test::MeshBuilder;
using test::Clear;

/// A round tub of one sheet on four feet: an upturned dome of 0.4 m with its rim at 0.5 m.
Builder tub() {
    Builder tub;
    constexpr int turns = 24, rings = 8;
    const auto at = [](int ring, int turn) {
        const double r = double(ring) / rings, a = 2 * 3.14159265358979 * turn / turns;
        return glm::dvec3(r * std::cos(a), 0.1 + 0.4 * r * r * r * r, 0.6 * r * std::sin(a));
    };
    for (int ring = 0; ring < rings; ++ring)
        for (int turn = 0; turn < turns; ++turn)
            tub.quad({at(ring, turn), at(ring + 1, turn), at(ring + 1, turn + 1), at(ring, turn + 1)});
    for (const double x : {-0.3, 0.3})
        for (const double z : {-0.2, 0.2})
            tub.box({x - 0.03, 0, z - 0.03}, {x + 0.03, 0.12, z + 0.03});
    return tub;
}

struct Case {
    const char* name;
    Builder made;
    double floor = 0, rim = 0;     ///< y; of no basin the same
    double surface = std::nan(""); ///< y
};

Case pools[] = {
    {"a pool of one mesh with something in it", Builder().pool().box({0, -1, 0}, {0.5, -0.4, 0.4}), -1.2, 0},
    {"a pool whose walls are thick",
     Builder().pool().sheet({-2.3, -1.3}, {2.3, 1.3}, -1.5).walls({-2.3, -1.3}, {2.3, 1.3}, -1.5, 0), -1.2,
     0},
    {"a pool of sheets in a garden with a house",
     Builder()
         .pool()
         .sheet({-8, -6}, {8, -1}, 0)
         .sheet({-8, 1}, {8, 6}, 0)
         .sheet({-8, -1}, {-2, 1}, 0)
         .sheet({2, -1}, {8, 1}, 0)
         .box({3, 0, 2}, {7, 3, 5}),
     -1.2, 0},
    {"a pool with a bridge", Builder().pool().box({-0.3, 0.2, -1.5}, {0.3, 0.4, 1.5}), -1.2, 0},
    {"a tub on feet", tub(), 0.1, 0.5},
    {"an aquarium of glass with gravel in it",
     Builder().box({-1, 0, -0.5}, {1, 0.1, 0.5}).walls({-1, -0.5}, {1, 0.5}, 0, 0.8, Clear), 0.1, 0.8},
    {"an aquarium all of glass",
     Builder().sheet({-1, -0.5}, {1, 0.5}, 0, Clear).walls({-1, -0.5}, {1, 0.5}, 0, 0.8, Clear), 0, 0.8},
    {"a lake",
     Builder().ground([](double x, double z) { return 0.1 * x * x - 0.2 * std::exp(-6 * (x * x + z * z)); }),
     -0.2, -0.0005},
    {"a pool with the author's water", Builder().pool().sheet({-2, -1}, {2, 1}, -0.2, Clear), -1.2, 0, -0.2},
    {"a pool with a body of water", Builder().pool().box({-1.99, -1.19, -0.99}, {1.99, -0.1, 0.99}, Clear),
     -1.2, 0, -0.1},
};

Case others[] = {
    {"a box", Builder().box({-1, 0, -1}, {1, 1, 1})},
    {"a pool with a lid", Builder().pool().sheet({-1.9, -0.9}, {1.9, 0.9}, 0.3)},
    {"a room with a door", Builder()
                               .sheet({-2, -1}, {2, 1}, 0)
                               .wall({-2, -1}, {2, -1}, 0, 2)
                               .wall({-2, -1}, {-2, 1}, 0, 2)
                               .wall({-2, 1}, {2, 1}, 0, 2)
                               .wall({2, -1}, {2, 0.5}, 0, 2)
                               .wall({2, 0.5}, {2, 1}, 1.5, 2)},
    {"a house with a parapet", Builder().box({-4, 0, -3}, {4, 3, 3}).walls({-4, -3}, {4, 3}, 3, 3.4)},
    {"a small bowl on a table", Builder().box({-2, 0, -2}, {2, 0.1, 2}).walls({0, 0}, {0.3, 0.3}, 0.1, 0.5)},
    {"rolling ground",
     Builder().ground([](double x, double z) { return 0.05 * std::sin(14 * x) * std::cos(14 * z); })},
    {"a sheet", Builder().sheet({-1, -1}, {1, 1}, 0)},
    {"a bottomless frame", Builder().walls({-2, -1}, {2, 1}, -1.2, 0)},
};

TEST(Basin, IsFoundWhereWaterStays) {
    for (const Case& c : pools) {
        const auto basin = findBasin(c.made.mesh);
        ASSERT_TRUE(basin) << c.name;
        Bounds bounds;
        for (const glm::dvec3& p : c.made.mesh.positions)
            bounds.add(p);
        const double cell = bounds.size().y / 96;
        EXPECT_NEAR(basin->water.min.y, c.floor, 2 * cell) << c.name;
        EXPECT_LE(basin->water.max.y, c.rim) << c.name << ": water would run over";
        EXPECT_GT(basin->water.max.y, c.rim - 3 * cell) << c.name;
        EXPECT_EQ(basin->surface.has_value(), !std::isnan(c.surface)) << c.name;
        if (basin->surface) {
            EXPECT_NEAR(*basin->surface, c.surface, 1e-9) << c.name;
        }
    }
}

TEST(Basin, TransmissiveWaterIsWaterToo) {
    Mesh mesh = Builder().pool().sheet({-2, -1}, {2, 1}, -0.2, Clear).mesh;
    mesh.materials[Clear] = {};
    EXPECT_FALSE(findBasin(mesh)) << "an opaque sheet is a lid";
    mesh.materials[Clear].transmission = 1;
    const auto basin = findBasin(mesh);
    ASSERT_TRUE(basin && basin->surface);
    EXPECT_NEAR(*basin->surface, -0.2, 1e-9);
}

TEST(Basin, ItsDepthIsTheMean) {
    EXPECT_NEAR(findBasin(Builder().pool().mesh)->depth, 1.2, 0.03);
    // A dome of r^4: 1 - 1/3 of its depth in the mean.
    EXPECT_NEAR(findBasin(tub().mesh)->depth, 0.4 * 2 / 3, 0.02);
}

TEST(Basin, IsTheSameAtEverySize) {
    for (const double scale : {1e-3, 1e5}) {
        Mesh mesh = Builder().pool().mesh;
        for (glm::dvec3& p : mesh.positions)
            p = scale * p + glm::dvec3(7, 3, -5) * scale;
        const auto basin = findBasin(mesh);
        ASSERT_TRUE(basin);
        EXPECT_NEAR(basin->water.max.y / scale, 3, 0.03);
    }
}

TEST(Basin, IsNotFoundWhereWaterRunsOff) {
    for (const Case& c : others)
        EXPECT_FALSE(findBasin(c.made.mesh)) << c.name;
    Mesh side = Builder().pool().mesh;
    for (glm::dvec3& p : side.positions)
        p = {p.x, p.z, -p.y};
    EXPECT_FALSE(findBasin(side)) << "an open box on its side";
    EXPECT_FALSE(findBasin(makeSphere(1, glm::vec3(0.8f))));
}

TEST(Basin, IsNoneOfOurModels) {
    int models = 0;
    for (const auto& entry : std::filesystem::directory_iterator(test::rootFolder() + "/models"))
        if (entry.path().extension() == ".glb") {
            ++models;
            EXPECT_FALSE(findBasin(io::loadModel(entry.path()).mesh)) << entry.path().filename();
        }
    EXPECT_GT(models, 20);
}

} // namespace
} // namespace limpid
