#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/SmallGltf.h"
#include "io/TempFolder.h"
#include "io/gltf/Gltf.h"

namespace limpid::io {
namespace {

using nlohmann::json;
using test::errorOf;
using test::SmallGltf;
using test::TempFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Pool > (Water > Foam, Float) and Lamp, a triangle each; Float's mesh is named WaterToy, its material
/// Rubber.
SmallGltf pool() {
    SmallGltf gltf = test::triangleGltf();
    gltf.json["materials"] = {{{"name", "Tiles"}}, {{"name", "Rubber"}}};
    for (int i = 1; i < 5; ++i)
        gltf.addMesh({{"attributes", {{"POSITION", 0}}}, {"material", i == 3 ? 1 : 0}});
    const char* names[] = {"Pool", "Water", "Foam", "Float", "Lamp"};
    for (std::size_t i = 0; i < 5; ++i) {
        gltf.json["nodes"][i]["name"] = names[i];
        gltf.json["nodes"][i]["translation"] = {i, 0, 0};
    }
    gltf.json["meshes"][3]["name"] = "WaterToy";
    gltf.json["nodes"][0]["children"] = {1, 3};
    gltf.json["nodes"][1]["children"] = {2};
    gltf.json["scenes"] = {{{"nodes", {0, 4}}}};
    return gltf;
}

Mesh load(const SmallGltf& gltf, std::vector<std::string> without = {}) {
    const TempFolder folder;
    return loadGltf(folder.write("pool.gltf", gltf.text()), NamePatterns(std::move(without)));
}

/// Those that have triangles.
std::vector<std::string> namesIn(const Mesh& mesh) {
    std::vector<std::string> names;
    for (const MeshNode& node : mesh.nodes)
        if (node.vertexCount > 0) names.push_back(node.name);
    return names;
}

TEST(GltfVisibilityTest, AHiddenNodeHidesAllBelowIt) {
    SmallGltf gltf = pool();
    const auto setVisible = [&](int node, bool visible) {
        gltf.json["nodes"][node]["extensions"]["KHR_node_visibility"]["visible"] = visible;
    };
    EXPECT_EQ(load(gltf).triangleCount(), 5u);
    setVisible(1, true);
    EXPECT_EQ(load(gltf).triangleCount(), 5u);
    setVisible(1, false);
    setVisible(2, true);
    EXPECT_THAT(namesIn(load(gltf)), ElementsAre("Pool", "Float", "Lamp")) << "a child cannot show itself";
    gltf.json["nodes"][1]["extensions"]["KHR_node_visibility"] = json::object();
    EXPECT_EQ(load(gltf).triangleCount(), 5u) << "visible by default";
    gltf.json["extensionsRequired"] = {"KHR_node_visibility"};
    setVisible(0, false);
    EXPECT_THAT(namesIn(load(gltf)), ElementsAre("Lamp"));
}

TEST(GltfWithoutTest, LeavesOutNodesByTheirNameWithAllBelowThem) {
    const Mesh mesh = load(pool(), {"Water"});
    EXPECT_THAT(namesIn(mesh), ElementsAre("Pool", "Float", "Lamp"));
    EXPECT_THAT(mesh.notices, IsEmpty());
}

TEST(GltfWithoutTest, MatchesMeshesAndMaterialsAsWell) {
    EXPECT_THAT(namesIn(load(pool(), {"Water*"})), ElementsAre("Pool", "Lamp")) << "Float, by its mesh";
    EXPECT_THAT(namesIn(load(pool(), {"Rub?er"})), ElementsAre("Pool", "Water", "Foam", "Lamp"));
    EXPECT_THAT(namesIn(load(pool(), {"[FL]*"})), ElementsAre("Pool", "Water"));
    EXPECT_THAT(namesIn(load(pool(), {"water*", "pool"})), testing::SizeIs(5)) << "case counts";
}

TEST(GltfWithoutTest, ABackslashTakesACharacterAsItIs) {
    SmallGltf gltf = pool();
    gltf.json["nodes"][4]["name"] = "Lamp*";
    EXPECT_THAT(namesIn(load(gltf, {"L*\\*"})), ElementsAre("Pool", "Water", "Foam", "Float"));
    EXPECT_EQ(load(gltf, {"Wa\\*"}).triangleCount(), 5u);
}

TEST(GltfWithoutTest, TellsOfPatternsThatStandForNothing) {
    EXPECT_THAT(load(pool(), {"Watr", "Foam"}).notices,
                ElementsAre(HasSubstr(
                    "pool.gltf: without: expected the name of a node, mesh or material (Float, Foam, "
                    "Lamp, Pool, Rubber, Tiles, Water, WaterToy), found \"Watr\"")));
    EXPECT_THAT(load(pool(), {"Water", "Foam"}).notices, IsEmpty())
        << "Foam is there, though it goes with Water";
}

TEST(GltfWithoutTest, AllOfItIsAnError) {
    const TempFolder folder;
    const auto file = folder.write("pool.gltf", pool().text());
    EXPECT_EQ(errorOf(folder, [&] { loadGltf(file, NamePatterns({"*"})); }),
              "pool.gltf: scene: expected a mesh with triangles, found no triangles but those left out");
}

} // namespace
} // namespace limpid::io
