#include "plan/ModelWarnings.h"

#include <gmock/gmock.h>

#include "engine/Scenes.h"

namespace limpid {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Material clear(AlphaMode mode, float transmission) {
    Material material;
    material.alphaMode = mode;
    material.transmission = transmission;
    if (mode == AlphaMode::Blend) material.baseColor.a = 0.5f;
    return material;
}

/// Adds a node to a receiver's mesh.
void add(Mesh& mesh, const char* name, const Mesh& node, const glm::dvec3& translation,
         const Material& material) {
    const auto first = std::uint32_t(mesh.positions.size()), index = std::uint32_t(mesh.indices.size());
    for (const glm::dvec3& p : node.positions)
        mesh.positions.push_back(p + translation);
    for (const std::uint32_t i : node.indices)
        mesh.indices.push_back(first + i);
    mesh.parts.push_back({index, std::uint32_t(node.indices.size()), int(mesh.materials.size())});
    mesh.materials.push_back(material);
    mesh.nodes.push_back({name, "", first, std::uint32_t(node.positions.size())});
}

/// A basin's floor 1 m below the level and one node more.
Receiver poolWith(const char* name, const Mesh& node, double y, const Material& material) {
    Mesh mesh;
    add(mesh, "Basin", makePlane(glm::dvec2(4), glm::vec3(0.8f)), {0, -1, 0}, Material{});
    add(mesh, name, node, {0, y, 0}, material);
    return {"pool", std::make_shared<const Mesh>(std::move(mesh))};
}

Mesh sheet() {
    return makePlane(glm::dvec2(4), glm::vec3(1));
}

Mesh body() {
    return makeBox(glm::dvec3(1, 0.5, 1), glm::vec3(1));
}

std::vector<std::string> warningsOf(const Receiver& receiver) {
    Water water;
    water.waves = {scenes::cosine(0.01, 0.3, {1, 0})};
    return modelWarnings(receiver, water);
}

TEST(ModelWarnings, areNoneForSolidThingsAndClearOnesInTheAir) {
    EXPECT_THAT(warningsOf(poolWith("Stone", body(), -0.5, Material{})), IsEmpty());
    EXPECT_THAT(warningsOf(poolWith("underwater_rock", body(), -0.5, Material{})), IsEmpty());
    EXPECT_THAT(warningsOf(poolWith("Lamp", body(), 3, clear(AlphaMode::Opaque, 1))), IsEmpty());
    EXPECT_THAT(warningsOf(poolWith("Table", sheet(), 0.7, clear(AlphaMode::Blend, 0))), IsEmpty());
    EXPECT_THAT(warningsOf(poolWith("Window", sheet(), -0.7, clear(AlphaMode::Blend, 0))), IsEmpty())
        << "thin";
    EXPECT_THAT(warningsOf(scenes::floorAt(-1)), IsEmpty()) << "a shape has no nodes";
    Material blended;
    blended.alphaMode = AlphaMode::Blend;
    EXPECT_THAT(warningsOf(poolWith("Fish", body(), -0.5, blended)), IsEmpty()) << "alpha is 1 all over";
}

TEST(ModelWarnings, nameWaterByNodeMeshOrMaterialWhateverItIsOf) {
    const char* expected =
        "receiver.pool: expected no water but the scene's own, found \"Water\" (water by its name); "
        "without = [\"Water\"] of the receiver leaves it out (--without, of a model alone)";
    EXPECT_THAT(warningsOf(poolWith("Water", sheet(), -0.1, Material{})), ElementsAre(expected));
    Receiver named = poolWith("Plane.001", sheet(), -0.1, Material{});
    Mesh mesh = *named.mesh;
    mesh.nodes[1].meshName = "Water";
    named.mesh = std::make_shared<const Mesh>(mesh);
    EXPECT_THAT(warningsOf(named), ElementsAre(expected));
    Material water;
    water.name = "Water";
    EXPECT_THAT(warningsOf(poolWith("Plane.001", sheet(), -0.1, water)), ElementsAre(expected));
}

TEST(ModelWarnings, nameClearSheetsAtTheLevelAndClosedClearBodiesBelowIt) {
    for (const Material& material : {clear(AlphaMode::Opaque, 1), clear(AlphaMode::Blend, 0)}) {
        EXPECT_THAT(warningsOf(poolWith("Surface", sheet(), -0.03, material)),
                    ElementsAre(HasSubstr("found \"Surface\" (a clear sheet at the water's level)")));
        EXPECT_THAT(
            warningsOf(poolWith("Marble", body(), -0.6, material)),
            ElementsAre(HasSubstr("found \"Marble\" (a closed clear body in the water, in which nothing "
                                  "refracts)")));
    }
}

TEST(ModelWarnings, findLowAlphaInPicturesAndVertexColorsToo) {
    Material blended;
    blended.alphaMode = AlphaMode::Blend;
    const Receiver solid = poolWith("Marble", body(), -0.6, blended);
    Receiver pictured = solid, colored = solid;
    Mesh mesh = *solid.mesh;
    mesh.colors.assign(mesh.positions.size(), glm::vec4(1, 1, 1, 0.5f));
    colored.mesh = std::make_shared<const Mesh>(mesh);
    mesh = *solid.mesh;
    mesh.images = {Image{2, 1, {1, 2, 3, 255, 1, 2, 3, 128}}};
    mesh.materials.back().baseColorImage = 0;
    pictured.mesh = std::make_shared<const Mesh>(mesh);
    for (const Receiver& receiver : {pictured, colored})
        EXPECT_THAT(warningsOf(receiver), ElementsAre(HasSubstr("found \"Marble\"")));
}

TEST(ModelWarnings, theirPatternsStandForTheNamesAlone) {
    EXPECT_THAT(warningsOf(poolWith("Water [1]*", sheet(), 0, Material{})),
                ElementsAre(HasSubstr(R"(without = ["Water \\[1]\\*"])")));
    EXPECT_THAT(warningsOf(poolWith(R"(A"B\C)", sheet(), 0, clear(AlphaMode::Blend, 0))),
                ElementsAre(HasSubstr(R"(without = ["A\"B\\\\C"])")));
    EXPECT_THAT(warningsOf(poolWith("Water\n2", sheet(), 0, Material{})),
                ElementsAre(testing::AllOf(HasSubstr("\"Water 2\""), HasSubstr("\"Water?2\""))));
    EXPECT_THAT(
        warningsOf(poolWith("", sheet(), 0, clear(AlphaMode::Blend, 0))),
        ElementsAre(testing::EndsWith("found a node without a name (a clear sheet at the water's level)")));
}

} // namespace
} // namespace limpid
