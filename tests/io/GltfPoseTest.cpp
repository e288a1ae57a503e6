#include <cmath>
#include <functional>

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
using test::triangleGltf;
using test::trianglePositions;
using testing::HasSubstr;

Mesh load(const SmallGltf& gltf) {
    const TempFolder folder;
    return loadGltf(folder.write("model.gltf", gltf.text()));
}

void expectNear(const glm::dvec3& found, const glm::dvec3& expected) {
    EXPECT_LT(glm::length(found - expected), 1e-6)
        << found.x << ", " << found.y << ", " << found.z << " is not " << expected.x << ", " << expected.y
        << ", " << expected.z;
}

json& primitive(SmallGltf& gltf) {
    return gltf.json["meshes"][0]["primitives"][0];
}

/// Column-major, of a translation.
std::vector<float> translation(float x, float y, float z) {
    return {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1};
}

/// The triangle with two joints: node 1 moves by 10 along x, node 2, its child, by 1 along y and turns by 90
/// degrees about z. Vertex 0 goes with the first, vertex 1 with the second, vertex 2 with half of each.
SmallGltf skinnedGltf() {
    SmallGltf gltf = triangleGltf();
    json& attributes = primitive(gltf)["attributes"];
    attributes["JOINTS_0"] = gltf.add<std::uint8_t>("VEC4", {0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0});
    attributes["WEIGHTS_0"] = gltf.add<float>("VEC4", {1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0});
    attributes["NORMAL"] = gltf.add<float>("VEC3", {1, 0, 0, 1, 0, 0, 0, 0, 1});
    std::vector<float> inverses = translation(0, 0, 0);
    const std::vector<float> second = translation(-1, 0, 0);
    inverses.insert(inverses.end(), second.begin(), second.end());
    const int view = gltf.addView(inverses.data(), inverses.size() * sizeof(float));
    const double half = std::sqrt(0.5);
    gltf.json["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"translation", {500, 500, 500}}},
                          {{"children", {2}}, {"translation", {10, 0, 0}}},
                          {{"translation", {0, 1, 0}}, {"rotation", {0, 0, half, half}}}};
    gltf.json["skins"] = {
        {{"joints", {1, 2}},
         {"inverseBindMatrices",
          gltf.addAccessor(
              {{"bufferView", view}, {"componentType", 5126}, {"count", 2}, {"type", "MAT4"}})}}};
    return gltf;
}

TEST(GltfSkinTest, VerticesGoWithTheirJointsAndNotWithTheNode) {
    const Mesh mesh = load(skinnedGltf());
    expectNear(mesh.positions[0], {10, 0, 0});
    expectNear(mesh.positions[1], {10, 1, 0}); // the second joint's own place
    // (0, 1, 0) by the first: (10, 1, 0); by the second: (−1, 1, 0) turned to (−1, −1, 0) and moved.
    expectNear(mesh.positions[2], 0.5 * (glm::dvec3(10, 1, 0) + glm::dvec3(9, 0, 0)));
    expectNear(glm::dvec3(mesh.normals[0]), {1, 0, 0});
    expectNear(glm::dvec3(mesh.normals[1]), {0, 1, 0});
    expectNear(glm::dvec3(mesh.normals[2]), {0, 0, 1});
}

TEST(GltfSkinTest, IntegerWeightsWeightsOfNothingAndNoInverses) {
    SmallGltf gltf = skinnedGltf();
    const int weights = gltf.add<std::uint8_t>("VEC4", {255, 0, 0, 0, 0, 0, 0, 0, 100, 100, 0, 0});
    gltf.json["accessors"][weights]["normalized"] = true;
    primitive(gltf)["attributes"]["WEIGHTS_0"] = weights;
    gltf.json["skins"][0].erase("inverseBindMatrices");
    const Mesh mesh = load(gltf);
    expectNear(mesh.positions[0], {10, 0, 0});
    expectNear(mesh.positions[1], {10, 2, 0}); // by its first joint
    expectNear(mesh.positions[2], 0.5 * (glm::dvec3(10, 1, 0) + glm::dvec3(9, 1, 0)));
}

TEST(GltfSkinTest, JointsThatMirrorTurnTheTriangleRound) {
    SmallGltf gltf = skinnedGltf();
    gltf.json["nodes"][1]["scale"] = {1, 1, -1};
    const Mesh mesh = load(gltf);
    const glm::dvec3 a = mesh.positions[mesh.indices[0]], b = mesh.positions[mesh.indices[1]],
                     c = mesh.positions[mesh.indices[2]];
    EXPECT_LT(glm::cross(b - a, c - a).z, 0);
}

TEST(GltfSkinTest, WithoutJointsAMeshFollowsItsNode) {
    SmallGltf gltf = skinnedGltf();
    primitive(gltf)["attributes"].erase("JOINTS_0");
    expectNear(load(gltf).positions[0], {500, 500, 500});
}

TEST(GltfMorphTest, TheNodesWeightsStandForTheMeshs) {
    SmallGltf gltf = triangleGltf();
    primitive(gltf)["attributes"]["NORMAL"] = gltf.add<float>("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1});
    const std::vector<float> up = {0, 0, 1, 0, 0, 1, 0, 0, 1};
    primitive(gltf)["targets"] = {{{"POSITION", gltf.add<float>("VEC3", up)}},
                                  {{"POSITION", gltf.add<float>("VEC3", {1, 0, 0, 1, 0, 0, 1, 0, 0})},
                                   {"NORMAL", gltf.add<float>("VEC3", {1, 0, -1, 0, 0, 0, 0, 0, 0})}}};
    expectNear(load(gltf).positions[0], {0, 0, 0});
    gltf.json["meshes"][0]["weights"] = {0.5, 1};
    expectNear(load(gltf).positions[0], {1, 0, 0.5});
    expectNear(glm::dvec3(load(gltf).normals[0]), {1, 0, 0});
    gltf.json["nodes"][0]["weights"] = {2};
    expectNear(load(gltf).positions[0], {0, 0, 2});
    expectNear(glm::dvec3(load(gltf).normals[0]), {0, 0, 1});
}

TEST(GltfMorphTest, ColorsAndTextureCoordinatesMorphToo) {
    SmallGltf gltf = triangleGltf();
    json& attributes = primitive(gltf)["attributes"];
    attributes["COLOR_0"] =
        gltf.add<float>("VEC4", {0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5});
    attributes["TEXCOORD_0"] = gltf.add<float>("VEC2", {0, 0, 1, 0, 0, 1});
    const int less = gltf.add<std::int8_t>("VEC4", {-127, 0, 127, 127, 0, 0, 0, 0, 0, 0, 0, 0});
    gltf.json["accessors"][less]["normalized"] = true;
    primitive(gltf)["targets"] = {{{"COLOR_0", less}},
                                  {{"COLOR_0", gltf.add<float>("VEC3", {0, 1, 0, 0, 1, 0, 0, 1, 0})},
                                   {"TEXCOORD_0", gltf.add<float>("VEC2", {2, 3, 0, 0, 0, 0})}}};
    gltf.json["meshes"][0]["weights"] = {1, 0.25};
    const Mesh mesh = load(gltf);
    // Clamped after they are added; a target without alpha leaves it alone.
    EXPECT_EQ(mesh.colors[0], glm::vec4(0, 0.75, 1, 1));
    EXPECT_EQ(mesh.colors[1], glm::vec4(0.5, 0.75, 0.5, 0.5));
    EXPECT_EQ(mesh.uvs[0], glm::vec2(0.5, 0.75));
    EXPECT_EQ(mesh.uvs[1], glm::vec2(1, 0));
}

json& instancing(SmallGltf& gltf) {
    return gltf.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
}

TEST(GltfInstancingTest, EveryInstanceIsACopyInTheNodesSpace) {
    SmallGltf gltf = triangleGltf();
    gltf.json["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
    gltf.json["nodes"][0]["translation"] = {0, 0, 5};
    instancing(gltf)["TRANSLATION"] = gltf.add<float>("VEC3", {1, 0, 0, 2, 0, 0});
    const int rotations = gltf.add<std::int16_t>("VEC4", {0, 0, 0, 32767, 0, 0, 23170, 23170});
    gltf.json["accessors"][rotations]["normalized"] = true;
    instancing(gltf)["ROTATION"] = rotations;
    instancing(gltf)["SCALE"] = gltf.add<float>("VEC3", {1, 1, 1, 3, 3, -3});
    const Mesh mesh = load(gltf);
    ASSERT_EQ(mesh.triangleCount(), 2u);
    expectNear(mesh.positions[mesh.indices[1]], {2, 0, 5});
    expectNear(mesh.positions[mesh.indices[3]], {2, 0, 5});
    expectNear(mesh.positions[mesh.indices[5]], {2, 3, 5}); // (1, 0, 0), last as a mirror turns corners round
    EXPECT_EQ(mesh.parts.size(), 1u);
}

TEST(GltfInstancingTest, NoInstancesAreNoTriangles) {
    SmallGltf gltf = triangleGltf();
    gltf.addMesh(primitive(gltf));
    instancing(gltf)["SCALE"] = gltf.addAccessor({{"componentType", 5126}, {"count", 0}, {"type", "VEC3"}});
    EXPECT_EQ(load(gltf).triangleCount(), 1u);
}

struct BrokenCase {
    const char* name;
    std::function<void(SmallGltf&)> breakIt; ///< the skinned triangle
    const char* error;
};

std::ostream& operator<<(std::ostream& out, const BrokenCase& c) {
    return out << c.name;
}

class GltfPoseErrorsTest : public testing::TestWithParam<BrokenCase> {};

TEST_P(GltfPoseErrorsTest, NamesThePlace) {
    SmallGltf gltf = skinnedGltf();
    GetParam().breakIt(gltf);
    const TempFolder folder;
    const auto file = folder.write("model.gltf", gltf.text());
    EXPECT_THAT(errorOf(folder, [&] { loadGltf(file); }), HasSubstr(GetParam().error));
}

const BrokenCase broken[] = {
    {"skin", [](SmallGltf& g) { g.json["nodes"][0]["skin"] = 1; },
     "nodes[0].skin: expected an index below 1, found 1"},
    {"joint node",
     [](SmallGltf& g) {
         g.json["skins"][0]["joints"] = {1, 3};
     },
     "skins[0].joints[1]: expected an index below 3, found 3"},
    {"no joints", [](SmallGltf& g) { g.json["skins"][0]["joints"] = json::array(); }, "expected"},
    {"joint of a vertex", [](SmallGltf& g) { g.json["skins"][0]["joints"] = {1}; },
     "attributes.JOINTS_0[1]: expected joints below 1, found 1"},
    {"inverses",
     [](SmallGltf& g) {
         g.json["skins"][0]["joints"] = {1, 2, 1};
     },
     "skins[0].inverseBindMatrices: expected 3 matrices, one for each joint, found 2"},
    {"inverses' type", [](SmallGltf& g) { g.json["skins"][0]["inverseBindMatrices"] = 0; },
     "expected matrices of 4 by 4 floats"},
    {"weights missing at the end",
     [](SmallGltf& g) {
         primitive(g)["attributes"]["WEIGHTS_0"] = g.add<float>("VEC4", {1, 0, 0, 0});
     },
     "WEIGHTS_0: expected 3 elements, as POSITION has, found 1"},
    {"joint's transform",
     [](SmallGltf& g) {
         g.json["nodes"][2]["rotation"] = {0, 0, 0, 0};
     },
     "nodes[2].rotation: expected a quaternion of length 1, found length 0"},
    {"target",
     [](SmallGltf& g) {
         primitive(g)["targets"] = {{{"POSITION", 99}}};
         g.json["nodes"][0]["weights"] = {1};
     },
     "targets[0].attributes.POSITION: expected an index below"},
    {"target missing at the end",
     [](SmallGltf& g) {
         primitive(g)["targets"] = {{{"POSITION", g.add<float>("VEC3", {0, 0, 0})}}};
         g.json["nodes"][0]["weights"] = {1};
     },
     "targets[0].attributes.POSITION: expected 3 elements, as POSITION has, found 1"},
    {"instances that differ in number",
     [](SmallGltf& g) {
         instancing(g)["TRANSLATION"] = g.add<float>("VEC3", trianglePositions);
         instancing(g)["SCALE"] = g.add<float>("VEC3", {1, 1, 1});
     },
     "EXT_mesh_gpu_instancing.attributes.SCALE: expected 3 instances, as the others have, found 1"},
    {"more instances than the file has bytes",
     [](SmallGltf& g) {
         instancing(g)["SCALE"] =
             g.addAccessor({{"componentType", 5126}, {"count", 100000}, {"type", "VEC3"}});
     },
     "EXT_mesh_gpu_instancing.attributes.SCALE: expected at most "},
    {"nodes that together have more instances than the file has bytes",
     [](SmallGltf& g) {
         instancing(g)["SCALE"] = g.addAccessor({{"componentType", 5126}, {"count", 600}, {"type", "VEC3"}});
         for (int i = 0; i < 9; ++i)
             g.json["nodes"].push_back({{"mesh", 0}, {"extensions", g.json["nodes"][0]["extensions"]}});
         g.json.erase("scene");
         g.json.erase("scenes");
     },
     "instances, found 600"},
    {"more triangles than there may be",
     [](SmallGltf& g) {
         g.json["nodes"][0].erase("skin");
         const int rotations = g.add<std::int8_t>("VEC4", std::vector<std::int8_t>(4 * 65536, 127));
         g.json["accessors"][std::size_t(rotations)]["normalized"] = true;
         instancing(g)["ROTATION"] = rotations;
         std::vector<std::uint8_t> indices;
         for (int i = 0; i < 3 * 683; ++i)
             indices.push_back(static_cast<std::uint8_t>(i % 3));
         primitive(g)["indices"] = g.add<std::uint8_t>("SCALAR", indices);
     },
     "meshes[0].primitives[0]: expected at most 682 triangles, found 683"},
    {"instance's index", [](SmallGltf& g) { instancing(g)["SCALE"] = "many"; },
     "SCALE: expected a whole number >= 0, found something else"},
};
INSTANTIATE_TEST_SUITE_P(All, GltfPoseErrorsTest, testing::ValuesIn(broken));

} // namespace
} // namespace limpid::io
