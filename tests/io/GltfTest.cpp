#include "io/gltf/Gltf.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/SmallGltf.h"
#include "io/TempFolder.h"

namespace limpid::io {
namespace {

using nlohmann::json;
using test::SmallGltf;
using test::TempFolder;
using test::triangleGltf;
using test::trianglePositions;
using testing::ElementsAre;

Mesh load(const SmallGltf& gltf) {
    const TempFolder folder;
    return loadGltf(folder.write("model.gltf", gltf.text()));
}

glm::dvec3 faceNormal(const Mesh& mesh, std::size_t triangle) {
    const auto corner = [&](std::size_t c) { return mesh.positions[mesh.indices[3 * triangle + c]]; };
    return glm::normalize(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
}

void expectNear(const glm::dvec3& a, const glm::dvec3& b, double tolerance = 1e-6) {
    EXPECT_LT(glm::length(a - b), tolerance) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(GltfTest, ATriangleAloneGetsFlatNormalsAndTheDefaultMaterial) {
    const Mesh mesh = load(triangleGltf());
    EXPECT_THAT(mesh.positions, ElementsAre(glm::dvec3(0), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)));
    EXPECT_THAT(mesh.indices, ElementsAre(0, 1, 2));
    for (const glm::vec3& normal : mesh.normals)
        EXPECT_EQ(normal, glm::vec3(0, 0, 1));
    EXPECT_EQ(mesh.uvs.size(), 3u);
    ASSERT_EQ(mesh.parts.size(), 1u);
    EXPECT_EQ(mesh.parts[0].indexCount, 3u);
    ASSERT_EQ(mesh.materials.size(), 1u);
    EXPECT_EQ(mesh.materials[0].baseColor, glm::vec4(1));
    EXPECT_EQ(mesh.materials[0].baseColorImage, -1);
}

TEST(GltfTest, BinaryAndTextAreTheSameWhateverTheSuffix) {
    const TempFolder folder;
    for (const char* name : {"a.glb", "b.gltf"})
        EXPECT_EQ(loadGltf(folder.write(name, triangleGltf().glb())).triangleCount(), 1u);
    EXPECT_EQ(loadGltf(folder.write("c.glb", triangleGltf().text())).triangleCount(), 1u);
}

/// Positions (0,0,0) (1,0,0) (1,1,0) (0,1,0) and two more that nothing should use.
template <typename Index>
SmallGltf square(const std::vector<Index>& indices, int mode) {
    SmallGltf gltf;
    const int positions = gltf.add<float>("VEC3", {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 5, 5, 5, 6, 6, 6});
    const int normals = gltf.add<float>("VEC3", {0, 0, 1, 0, 0, 2, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
    gltf.addMesh({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}},
                  {"indices", gltf.add("SCALAR", indices)},
                  {"mode", mode}});
    return gltf;
}

TEST(GltfTest, ListsStripsAndFansOfEveryIndexTypeMakeTheSameSquare) {
    const SmallGltf gltfs[] = {
        square<std::uint8_t>({0, 1, 2, 0, 2, 3}, 4),
        square<std::uint16_t>({0, 1, 2, 0, 2, 3}, 4),
        square<std::uint32_t>({0, 1, 2, 0, 2, 3}, 4),
        square<std::uint8_t>({0, 1, 3, 2}, 5),
        square<std::uint16_t>({0, 1, 2, 3}, 6),
        square<std::uint32_t>({0, 1, 2, 0, 2, 3, 0, 1}, 4),    // the incomplete one is left out
        square<std::uint32_t>({0, 1, 2, 2, 2, 3, 0, 2, 3}, 4), // so are those that use a vertex twice
    };
    for (const SmallGltf& gltf : gltfs) {
        const Mesh mesh = load(gltf);
        ASSERT_EQ(mesh.triangleCount(), 2u) << gltf.text();
        EXPECT_EQ(mesh.positions.size(), 4u) << "only what triangles use";
        for (const std::size_t triangle : {0u, 1u})
            expectNear(faceNormal(mesh, triangle), {0, 0, 1});
        for (const glm::vec3& normal : mesh.normals)
            EXPECT_EQ(normal, glm::vec3(0, 0, 1));
    }
}

TEST(GltfTest, PointsAndLinesAreIgnored) {
    SmallGltf gltf = triangleGltf();
    for (const int mode : {0, 1, 2, 3})
        gltf.addMesh({{"attributes", {{"POSITION", 0}}}, {"mode", mode}});
    EXPECT_EQ(load(gltf).triangleCount(), 1u);
}

TEST(GltfTest, StridesOffsetsAndInterleavedAttributes) {
    SmallGltf gltf;
    std::vector<float> data = {99}; // the accessors begin 4 bytes in
    for (std::size_t v = 0; v < 3; ++v) {
        data.insert(data.end(), trianglePositions.begin() + 3 * v, trianglePositions.begin() + 3 * v + 3);
        data.insert(data.end(), {0, 0, -1, float(v), 0.5f});
    }
    const int view = gltf.addView(data.data(), data.size() * sizeof(float));
    gltf.json["bufferViews"][view]["byteStride"] = 32;
    const auto accessor = [&](int offset, const char* type) {
        return gltf.addAccessor({{"bufferView", view},
                                 {"byteOffset", offset},
                                 {"componentType", 5126},
                                 {"count", 3},
                                 {"type", type}});
    };
    const int positions = accessor(4, "VEC3"), normals = accessor(16, "VEC3"), uvs = accessor(28, "VEC2");
    gltf.addMesh({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}, {"TEXCOORD_0", uvs}}}});
    const Mesh mesh = load(gltf);
    EXPECT_THAT(mesh.positions, ElementsAre(glm::dvec3(0), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)));
    EXPECT_EQ(mesh.normals[1], glm::vec3(0, 0, -1)) << "the file's, even against the winding";
    EXPECT_THAT(mesh.uvs, ElementsAre(glm::vec2(0, 0.5), glm::vec2(1, 0.5), glm::vec2(2, 0.5)));
}

TEST(GltfTest, QuantizedAndNormalizedAttributes) {
    SmallGltf gltf;
    gltf.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    const int positions = gltf.add<std::int16_t>("VEC3", {0, 0, 0, 100, 0, 0, 0, -200, 0});
    const int normals = gltf.add<std::int8_t>("VEC3", {0, 0, 127, 0, 0, -128, 127, 0, 0});
    gltf.json["accessors"][normals]["normalized"] = true;
    const int uvs = gltf.add<std::uint16_t>("VEC2", {0, 65535, 13107, 0, 0, 0});
    gltf.json["accessors"][uvs]["normalized"] = true;
    gltf.addMesh({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}, {"TEXCOORD_0", uvs}}}});
    const Mesh mesh = load(gltf);
    EXPECT_THAT(mesh.positions, ElementsAre(glm::dvec3(0), glm::dvec3(100, 0, 0), glm::dvec3(0, -200, 0)));
    EXPECT_THAT(mesh.normals, ElementsAre(glm::vec3(0, 0, 1), glm::vec3(0, 0, -1), glm::vec3(1, 0, 0)));
    EXPECT_EQ(mesh.uvs[0], glm::vec2(0, 1));
    EXPECT_FLOAT_EQ(mesh.uvs[1].x, 0.2f);
}

TEST(GltfTest, SparseAccessorsReplaceElementsOfTheirViewOrOfZeros) {
    for (const bool withView : {true, false}) {
        SmallGltf gltf = triangleGltf();
        const std::vector<std::uint8_t> indices = {1, 2};
        const std::vector<float> values = {3, 0, 0, 0, 4, 0};
        json& accessor = gltf.json["accessors"][0];
        accessor["sparse"] = {
            {"count", 2},
            {"indices", {{"bufferView", gltf.addView(indices.data(), 2)}, {"componentType", 5121}}},
            {"values", {{"bufferView", gltf.addView(values.data(), 24)}}}};
        if (!withView) accessor.erase("bufferView");
        EXPECT_THAT(load(gltf).positions,
                    ElementsAre(glm::dvec3(0), glm::dvec3(3, 0, 0), glm::dvec3(0, 4, 0)));
    }
}

TEST(GltfTest, NodeTransformsMultiplyInDoublePrecision) {
    SmallGltf gltf = triangleGltf();
    const double half = std::sqrt(0.5);
    gltf.json["nodes"] = {{{"children", {1}}, {"translation", {1e8, 0, 0}}},
                          {{"children", {2}}, {"rotation", {0, 0, half, half}}, {"scale", {2, 3, 4}}},
                          {{"mesh", 0}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.25, 0, 0, 1}}}};
    gltf.json["scenes"] = {{{"nodes", {0}}}};
    const Mesh mesh = load(gltf);
    expectNear(mesh.positions[0], {1e8, 0.5, 0});
    expectNear(mesh.positions[1], {1e8, 2.5, 0});
    expectNear(mesh.positions[2], {1e8 - 3, 0.5, 0});
}

TEST(GltfTest, NormalsStayOutsideUnderUnevenAndMirroringScales) {
    const double s = std::sqrt(0.5);
    for (const json& scale :
         {json{1, 1, 1}, json{4, 1, 1}, json{-1, 1, 1}, json{-2, -3, -1}, json{1, 1, 0}}) {
        SmallGltf gltf;
        const int positions = gltf.add<float>("VEC3", {1, 0, 0, 0, 1, 0, 0, 1, 1}); // faces +x +y
        const float n = static_cast<float>(s);
        const int normals = gltf.add<float>("VEC3", {n, n, 0, n, n, 0, n, n, 0});
        gltf.addMesh({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}});
        gltf.json["nodes"][0]["scale"] = scale;
        const Mesh mesh = load(gltf);
        for (const glm::vec3& normal : mesh.normals) {
            EXPECT_NEAR(glm::length(normal), 1, 1e-6);
            if (scale[2] == 0) continue; // squeezed to a line: any direction will do
            expectNear(glm::dvec3(normal), faceNormal(mesh, 0));
            EXPECT_GT(normal.x * (scale[0] < 0 ? -1 : 1), 0) << scale;
        }
    }
}

TEST(GltfTest, NormalsThatHaveNoDirectionComeFromTheFaces) {
    SmallGltf gltf = triangleGltf();
    const float nan = std::nanf("");
    gltf.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] =
        gltf.add<float>("VEC3", {0, 0, 0, nan, 0, 0, 0, 1, 0});
    EXPECT_THAT(load(gltf).normals, ElementsAre(glm::vec3(0, 0, 1), glm::vec3(0, 0, 1), glm::vec3(0, 1, 0)));
}

TEST(GltfTest, TheDefaultSceneElseTheFirstElseAllRoots) {
    SmallGltf gltf = triangleGltf();
    gltf.json["nodes"] = json::array();
    for (int i = 0; i < 3; ++i)
        gltf.json["nodes"].push_back({{"mesh", 0}, {"translation", {i, 0, 0}}});
    EXPECT_EQ(load(gltf).triangleCount(), 3u);
    gltf.json["scenes"] = {{{"nodes", {1}}}, {{"nodes", {2, 0}}}};
    EXPECT_EQ(load(gltf).positions[0], glm::dvec3(1, 0, 0));
    gltf.json["scene"] = 1;
    const Mesh mesh = load(gltf);
    EXPECT_EQ(mesh.triangleCount(), 2u);
    EXPECT_EQ(mesh.positions[0], glm::dvec3(2, 0, 0));
    EXPECT_EQ(mesh.positions[3], glm::dvec3(0));
}

TEST(GltfTest, DeepChainsOfNodesAreNoProblem) {
    SmallGltf gltf = triangleGltf();
    constexpr int depth = 100000;
    json nodes = json::array();
    for (int i = 0; i < depth; ++i)
        nodes.push_back({{"children", {i + 1}}});
    nodes.push_back({{"mesh", 0}});
    gltf.json["nodes"] = nodes;
    EXPECT_EQ(load(gltf).triangleCount(), 1u);
}

TEST(GltfTest, ATriangleGivenTwiceIsOneWhicheverWayItIsWound) {
    SmallGltf gltf;
    const int corners = gltf.add<float>("VEC3", {0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 1, 0, 0});
    // The same corners, by other numbers, from another start, and the other way round; then another triangle.
    const int indices = gltf.add<std::uint16_t>("SCALAR", {0, 2, 1, 2, 4, 0, 0, 1, 2, 0, 1, 3});
    gltf.addMesh({{"attributes", {{"POSITION", corners}}}, {"indices", indices}});
    gltf.addMesh({{"attributes", {{"POSITION", corners}}}, {"indices", indices}, {"material", 0}});
    gltf.json["materials"] = json::array({json::object()});
    const Mesh mesh = load(gltf);
    ASSERT_EQ(mesh.parts.size(), 2u) << "another material is another triangle";
    // Without normals every corner is a vertex: the first and the fourth triangle are left.
    EXPECT_EQ(mesh.indices, (std::vector<std::uint32_t>{0, 1, 2, 9, 10, 11, 12, 13, 14, 21, 22, 23}));
    EXPECT_EQ(mesh.parts[0].indexCount, 6u);
    EXPECT_EQ(mesh.parts[1].firstIndex, 6u);
}

TEST(GltfTest, MaterialsSplitTheMeshIntoParts) {
    SmallGltf gltf = triangleGltf();
    gltf.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 0.25, 0, 0.75}}}}},
                              json::object()};
    gltf.json["meshes"][0]["primitives"][0]["material"] = 0;
    for (const int material : {1, 1, 0})
        gltf.addMesh({{"attributes", {{"POSITION", 0}}}, {"material", material}});
    gltf.addMesh({{"attributes", {{"POSITION", 0}}}});
    for (std::size_t i = 1; i < gltf.json["nodes"].size(); ++i)
        gltf.json["nodes"][i]["translation"] = {0, i, 0};
    const Mesh mesh = load(gltf);
    ASSERT_EQ(mesh.materials.size(), 3u);
    EXPECT_EQ(mesh.materials[0].baseColor, glm::vec4(0.5, 0.25, 0, 0.75));
    EXPECT_EQ(mesh.materials[1].baseColor, glm::vec4(1));
    ASSERT_EQ(mesh.parts.size(), 4u);
    const MeshPart expected[] = {{0, 3, 0}, {3, 6, 1}, {9, 3, 0}, {12, 3, 2}};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(mesh.parts[i].firstIndex, expected[i].firstIndex);
        EXPECT_EQ(mesh.parts[i].indexCount, expected[i].indexCount);
        EXPECT_EQ(mesh.parts[i].material, expected[i].material);
    }
}

/// Two pixels: red, and half transparent green.
const std::string png8 =
    "iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAYAAAD0In+KAAAAD0lEQVR42mP4z8DwHwgbABB5A37EGHKQAAAAAElFTkSuQmCC";
/// The same with 16 bits, and green half as bright with a blue of 1 in 255.
const std::string png16 =
    "iVBORw0KGgoAAAANSUhEUgAAAAIAAAABEAYAAACksqPJAAAAFUlEQVR42mP4/58BCEBkQwMjY0MDADjmBf8j8oWUAAAAAElF"
    "TkSuQmCC";

std::string decodeBase64(const std::string& text) {
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    for (std::size_t i = 0; i + 3 < text.size(); i += 4) {
        std::size_t group = 0;
        for (std::size_t k = 0; k < 4; ++k)
            group = group << 6 | (digits.find(text[i + k]) & 63);
        for (int shift : {16, 8, 0})
            bytes += static_cast<char>(group >> shift);
    }
    return bytes; // what padding adds is zeros after the end, which PNG ignores
}

SmallGltf textured(const json& image) {
    SmallGltf gltf = triangleGltf();
    json& primitive = gltf.json["meshes"][0]["primitives"][0];
    primitive["material"] = 0;
    primitive["attributes"]["TEXCOORD_0"] = gltf.add<float>("VEC2", {0, 0, 1, 0, 0, 1});
    primitive["attributes"]["TEXCOORD_1"] = gltf.add<float>("VEC2", {5, 5, 6, 6, 7, 7});
    gltf.json["images"] = json::array({image});
    gltf.json["textures"] = {{{"source", 0}}};
    gltf.json["materials"] = {{{"pbrMetallicRoughness",
                                {{"baseColorTexture", {{"index", 0}}}, {"baseColorFactor", {0, 1, 0, 1}}}}}};
    return gltf;
}

json& textureInfo(SmallGltf& gltf) {
    return gltf.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"];
}

TEST(GltfTextureTest, EightAndSixteenBitsComeOutAsRgba8) {
    const std::string prefix = "data:image/png;base64,";
    const Mesh mesh = load(textured({{"uri", prefix + png8}}));
    ASSERT_EQ(mesh.images.size(), 1u);
    EXPECT_EQ(mesh.materials[0].baseColorImage, 0);
    EXPECT_EQ(mesh.images[0].width, 2);
    EXPECT_EQ(mesh.images[0].height, 1);
    EXPECT_THAT(mesh.images[0].rgba, ElementsAre(255, 0, 0, 255, 0, 255, 0, 128));
    EXPECT_THAT(load(textured({{"uri", prefix + png16}})).images[0].rgba,
                ElementsAre(255, 0, 0, 255, 0, 128, 1, 128));
}

TEST(GltfTextureTest, OneImageServesAllItsMaterialsFromFilesToo) {
    const TempFolder folder;
    SmallGltf gltf = textured({{"uri", "my%20textures/a.png"}});
    gltf.json["materials"].push_back(gltf.json["materials"][0]);
    gltf.json["materials"].push_back(gltf.json["materials"][0]);
    gltf.addMesh({{"attributes", {{"POSITION", 0}}}, {"material", 1}});
    folder.write("my textures/a.png", decodeBase64(png8));
    const Mesh mesh = loadGltf(folder.write("model.gltf", gltf.text()));
    EXPECT_EQ(mesh.images.size(), 1u);
    EXPECT_EQ(mesh.materials[0].baseColorImage, 0);
    EXPECT_EQ(mesh.materials[1].baseColorImage, 0);
    EXPECT_EQ(mesh.materials[2].baseColorImage, -1) << "nothing uses it";
}

TEST(GltfTextureTest, ImagesInBufferViews) {
    SmallGltf gltf = textured({{"mimeType", "image/png"}});
    const std::string bytes = decodeBase64(png8);
    gltf.json["images"][0]["bufferView"] = gltf.addView(bytes.data(), bytes.size());
    EXPECT_THAT(load(gltf).images.at(0).rgba, ElementsAre(255, 0, 0, 255, 0, 255, 0, 128));
}

TEST(GltfTextureTest, ImagesThatAreNotThereCostTheTextureOnly) {
    for (const json& image :
         {json{{"uri", "none.png"}}, json{{"uri", "../secret.png"}}, json{{"uri", "https://x/y.png"}},
          json{{"uri", "data:image/png;base64,AAAA"}}, json{{"uri", "data:image/webp;base64,AAAA"}}}) {
        const Mesh mesh = load(textured(image));
        EXPECT_EQ(mesh.materials[0].baseColorImage, -1);
        EXPECT_EQ(mesh.materials[0].baseColor, glm::vec4(0, 1, 0, 1));
        ASSERT_FALSE(mesh.notices.empty());
        EXPECT_THAT(mesh.notices[0],
                    testing::MatchesRegex(".*model\\.gltf: images\\[0\\]: texture left out: .*"));
    }
}

TEST(GltfTextureTest, TheSetOfCoordinatesIsTheTextures) {
    SmallGltf gltf = textured({{"uri", "none.png"}});
    EXPECT_EQ(load(gltf).uvs[1], glm::vec2(1, 0));
    textureInfo(gltf)["texCoord"] = 1;
    EXPECT_EQ(load(gltf).uvs[1], glm::vec2(6, 6));
}

TEST(GltfTextureTest, TextureTransformsMoveTheCoordinates) {
    SmallGltf gltf = textured({{"uri", "none.png"}});
    textureInfo(gltf)["extensions"]["KHR_texture_transform"] = {
        {"offset", {0.5, 0.25}}, {"rotation", std::acos(-1.0) / 2}, {"scale", {2, 3}}};
    const Mesh mesh = load(gltf);
    // Scaled, then turned counter-clockwise in a picture whose v points down, then moved.
    EXPECT_LT(glm::length(mesh.uvs[0] - glm::vec2(0.5, 0.25)), 1e-6);
    EXPECT_LT(glm::length(mesh.uvs[1] - glm::vec2(0.5, 0.25 - 2)), 1e-6);
    EXPECT_LT(glm::length(mesh.uvs[2] - glm::vec2(0.5 + 3, 0.25)), 1e-6);
}

} // namespace
} // namespace limpid::io
