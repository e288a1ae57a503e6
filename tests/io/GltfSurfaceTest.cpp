#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/SmallGltf.h"
#include "io/TempFolder.h"
#include "io/gltf/Gltf.h"
#include "io/gltf/Images.h"

namespace limpid::io {
namespace {

using nlohmann::json;
using test::errorOf;
using test::SmallGltf;
using test::TempFolder;
using test::triangleGltf;
using testing::ElementsAre;
using testing::HasSubstr;

Mesh load(const SmallGltf& gltf) {
    const TempFolder folder;
    return loadGltf(folder.write("model.gltf", gltf.text()));
}

std::string loadError(const SmallGltf& gltf) {
    const TempFolder folder;
    const auto file = folder.write("model.gltf", gltf.text());
    return errorOf(folder, [&] { loadGltf(file); });
}

json& attributes(SmallGltf& gltf, int mesh = 0) {
    return gltf.json["meshes"][mesh]["primitives"][0]["attributes"];
}

/// Two pixels: red, and half transparent green.
const std::string png =
    "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAYAAAD0In+KAAAAD0lEQVR42mP4z8DwHwgb"
    "ABB5A37EGHKQAAAAAElFTkSuQmCC";

/// A triangle with two sets of coordinates and a material of its own, which has image 0 in texture 0.
SmallGltf texturedGltf(const json& material) {
    SmallGltf gltf = triangleGltf();
    gltf.json["meshes"][0]["primitives"][0]["material"] = 0;
    attributes(gltf)["TEXCOORD_0"] = gltf.add<float>("VEC2", {0, 0, 1, 0, 0, 1});
    attributes(gltf)["TEXCOORD_1"] = gltf.add<float>("VEC2", {5, 5, 6, 6, 7, 7});
    gltf.json["images"] = {{{"uri", png}}};
    gltf.json["textures"] = {{{"source", 0}}};
    gltf.json["materials"] = json::array({material});
    return gltf;
}

TEST(GltfColorsTest, EveryTypeComesOutTheSame) {
    const glm::vec4 expected(1, 0.2, 0, 1);
    const auto withColors = [](const auto& add) {
        SmallGltf gltf = triangleGltf();
        attributes(gltf)["COLOR_0"] = add(gltf);
        return load(gltf).colors;
    };
    const auto normalized = [](SmallGltf& gltf, int accessor) {
        gltf.json["accessors"][accessor]["normalized"] = true;
        return accessor;
    };
    const std::vector<std::vector<glm::vec4>> all = {
        withColors([](SmallGltf& g) {
            return g.add<float>("VEC3", {1, 0.2f, 0, 1, 0.2f, 0, 1, 0.2f, 0});
        }),
        withColors([](SmallGltf& g) {
            return g.add<float>("VEC4", {1, 0.2f, 0, 1, 1, 0.2f, 0, 1, 1, 0.2f, 0, 1});
        }),
        withColors([&](SmallGltf& g) {
            return normalized(
                g, g.add<std::uint8_t>("VEC4", {255, 51, 0, 255, 255, 51, 0, 255, 255, 51, 0, 255}));
        }),
        withColors([&](SmallGltf& g) {
            return normalized(
                g, g.add<std::uint16_t>("VEC3", {65535, 13107, 0, 65535, 13107, 0, 65535, 13107, 0}));
        })};
    for (const std::vector<glm::vec4>& colors : all) {
        ASSERT_EQ(colors.size(), 3u);
        for (const glm::vec4& color : colors)
            EXPECT_LT(glm::length(color - expected), 1e-6);
    }
}

TEST(GltfColorsTest, WhatIsOutOfRangeIsClampedAndNoNumberIsWhite) {
    SmallGltf gltf = triangleGltf();
    attributes(gltf)["COLOR_0"] = gltf.add<float>("VEC3", {-1, 2, std::nanf(""), INFINITY, 0, 0, 0, 0, 0});
    EXPECT_EQ(load(gltf).colors[0], glm::vec4(0, 1, 1, 1));
    EXPECT_EQ(load(gltf).colors[1], glm::vec4(1, 0, 0, 1));
}

TEST(GltfColorsTest, PrimitivesWithoutColorsAreWhiteBetweenThoseThatHaveSome) {
    SmallGltf gltf = triangleGltf();
    EXPECT_TRUE(load(gltf).colors.empty());
    const int black = gltf.add<float>("VEC3", std::vector<float>(9));
    gltf.addMesh({{"attributes", {{"POSITION", 0}, {"COLOR_0", black}}}});
    gltf.addMesh({{"attributes", {{"POSITION", 0}}}});
    const glm::vec4 white(1), dark(0, 0, 0, 1);
    EXPECT_THAT(load(gltf).colors, ElementsAre(white, white, white, dark, dark, dark, white, white, white));
}

TEST(GltfColorsTest, WrongTypesAndCountsAreErrors) {
    SmallGltf gltf = triangleGltf();
    attributes(gltf)["COLOR_0"] = gltf.add<float>("VEC3", {1, 1, 1});
    EXPECT_THAT(loadError(gltf), HasSubstr("COLOR_0: expected 3 elements, as POSITION has, found 1"));
    attributes(gltf)["COLOR_0"] = gltf.add<float>("VEC2", {1, 1, 1, 1, 1, 1});
    EXPECT_THAT(loadError(gltf), HasSubstr("expected vectors of 3 or 4 floats"));
}

TEST(GltfMaterialTest, AlphaAndSides) {
    SmallGltf gltf = triangleGltf();
    gltf.json["materials"] = {{{"alphaMode", "MASK"}, {"alphaCutoff", 0.25}, {"doubleSided", true}},
                              {{"alphaMode", "BLEND"}},
                              {{"alphaMode", "DITHER"}},
                              json::object()};
    const Mesh mesh = load(gltf);
    EXPECT_EQ(mesh.materials[0].alphaMode, AlphaMode::Mask);
    EXPECT_EQ(mesh.materials[0].alphaCutoff, 0.25f);
    EXPECT_TRUE(mesh.materials[0].doubleSided);
    EXPECT_EQ(mesh.materials[1].alphaMode, AlphaMode::Blend);
    EXPECT_EQ(mesh.materials[1].alphaCutoff, 0.5f);
    EXPECT_FALSE(mesh.materials[1].doubleSided);
    EXPECT_EQ(mesh.materials[2].alphaMode, AlphaMode::Opaque) << "of a later version";
    EXPECT_EQ(mesh.materials[3].alphaMode, AlphaMode::Opaque);
}

TEST(GltfMaterialTest, Samplers) {
    SmallGltf gltf = texturedGltf({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    Material material = load(gltf).materials[0];
    EXPECT_EQ(material.baseColorWrapS, Wrap::Repeat);
    EXPECT_EQ(material.baseColorWrapT, Wrap::Repeat);
    EXPECT_FALSE(material.baseColorNearest);
    gltf.json["textures"][0]["sampler"] = 0;
    EXPECT_THAT(loadError(gltf), HasSubstr("textures[0].sampler: expected no index"));
    gltf.json["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}}};
    material = load(gltf).materials[0];
    EXPECT_EQ(material.baseColorWrapS, Wrap::Clamp);
    EXPECT_EQ(material.baseColorWrapT, Wrap::Mirror);
    EXPECT_TRUE(material.baseColorNearest);
}

TEST(GltfMaterialTest, TransmissionIsAFactorTimesTheTexturesRed) {
    const json factor = {{"KHR_materials_transmission", {{"transmissionFactor", 0.75}}}};
    Material material = load(texturedGltf({{"extensions", factor}})).materials[0];
    EXPECT_EQ(material.transmission, 0.75f);
    EXPECT_EQ(material.transmissionImage, -1);
    EXPECT_EQ(load(texturedGltf(json::object())).materials[0].transmission, 0) << "without the extension";
    EXPECT_EQ(load(texturedGltf({{"extensions", {{"KHR_materials_transmission", json::object()}}}}))
                  .materials[0]
                  .transmission,
              0)
        << "the extension's default";

    SmallGltf gltf = texturedGltf({{"extensions", factor}});
    json& extension = gltf.json["materials"][0]["extensions"]["KHR_materials_transmission"];
    extension["transmissionTexture"] = {{"index", 0}, {"texCoord", 1}};
    gltf.json["textures"][0]["sampler"] = 0;
    gltf.json["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33648}}};
    const Mesh mesh = load(gltf);
    material = mesh.materials[0];
    ASSERT_EQ(material.transmissionImage, 0);
    EXPECT_FALSE(mesh.images[0].srgb) << "a share is no colour";
    EXPECT_EQ(material.transmissionWrapS, Wrap::Clamp);
    EXPECT_EQ(material.transmissionWrapT, Wrap::Mirror);
    EXPECT_EQ(mesh.uvs[1], glm::vec2(6, 6)) << "the only texture has the mesh's uvs";

    extension["transmissionTexture"]["index"] = 1;
    EXPECT_THAT(loadError(gltf),
                HasSubstr("materials[0].KHR_materials_transmission.transmissionTexture.index"));
    extension = {{"transmissionFactor", "all"}};
    EXPECT_THAT(loadError(gltf), HasSubstr("KHR_materials_transmission.transmissionFactor: expected"));
}

TEST(GltfMaterialTest, EmissionIsAFactorTimesItsStrength) {
    const Mesh mesh = load(
        texturedGltf({{"emissiveFactor", {1, 0.5, 0}},
                      {"emissiveTexture", {{"index", 0}}},
                      {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 4}}}}}}));
    EXPECT_EQ(mesh.materials[0].emission, glm::vec3(4, 2, 0));
    ASSERT_EQ(mesh.materials[0].emissionImage, 0);
    EXPECT_TRUE(mesh.images[0].srgb);
    EXPECT_EQ(load(texturedGltf(json::object())).materials[0].emission, glm::vec3(0));
}

TEST(GltfMaterialTest, TheDiffuseColorOfGlossinessIsTheBaseColor) {
    const Mesh mesh = load(texturedGltf(
        {{"extensions",
          {{"KHR_materials_pbrSpecularGlossiness",
            {{"diffuseFactor", {0.5, 0.25, 0, 1}}, {"diffuseTexture", {{"index", 0}, {"texCoord", 1}}}}}}}}));
    EXPECT_EQ(mesh.materials[0].baseColor, glm::vec4(0.5, 0.25, 0, 1));
    EXPECT_EQ(mesh.materials[0].baseColorImage, 0);
    EXPECT_EQ(mesh.uvs[1], glm::vec2(6, 6));
}

struct NormalMapCase {
    const char* name;
    json color, normal; ///< texture infos; null for none
    int images;
    bool used;
    glm::vec2 secondUv, secondNormalUv;
};

std::ostream& operator<<(std::ostream& out, const NormalMapCase& c) {
    return out << c.name;
}

class GltfNormalMapTest : public testing::TestWithParam<NormalMapCase> {};

TEST_P(GltfNormalMapTest, LiesWhereItsOwnCoordinatesSay) {
    const NormalMapCase& c = GetParam();
    json material = json::object();
    if (!c.color.is_null()) material["pbrMetallicRoughness"]["baseColorTexture"] = c.color;
    if (!c.normal.is_null()) material["normalTexture"] = c.normal;
    const Mesh mesh = load(texturedGltf(material));
    EXPECT_EQ(mesh.images.size(), static_cast<std::size_t>(c.images));
    EXPECT_EQ(mesh.materials[0].normalImage >= 0, c.used);
    EXPECT_EQ(mesh.uvs[1], c.secondUv);
    EXPECT_EQ(mesh.normalUvs.empty(), c.secondUv == c.secondNormalUv);
    if (!mesh.normalUvs.empty()) {
        EXPECT_EQ(mesh.normalUvs.size(), mesh.positions.size());
        EXPECT_EQ(mesh.normalUvs[1], c.secondNormalUv);
    }
    if (c.used) {
        EXPECT_EQ(mesh.materials[0].normalScale, 0.5f);
        EXPECT_FALSE(mesh.images[static_cast<std::size_t>(mesh.materials[0].normalImage)].srgb);
    }
    if (!c.color.is_null()) {
        EXPECT_TRUE(mesh.images[static_cast<std::size_t>(mesh.materials[0].baseColorImage)].srgb);
    }
}

const json moved = {{"KHR_texture_transform", {{"offset", {2, 0}}}}};
const NormalMapCase normalMaps[] = {
    {"base colour only", {{"index", 0}}, nullptr, 1, false, {1, 0}, {1, 0}},
    {"same set", {{"index", 0}}, {{"index", 0}, {"scale", 0.5}}, 2, true, {1, 0}, {1, 0}},
    {"other set", {{"index", 0}}, {{"index", 0}, {"texCoord", 1}, {"scale", 0.5}}, 2, true, {1, 0}, {6, 6}},
    {"other transform",
     {{"index", 0}},
     {{"index", 0}, {"extensions", moved}, {"scale", 0.5}},
     2,
     true,
     {1, 0},
     {3, 0}},
    {"same transform",
     {{"index", 0}, {"extensions", moved}},
     {{"index", 0}, {"extensions", moved}, {"scale", 0.5}},
     2,
     true,
     {3, 0},
     {3, 0}},
    {"normal map only", nullptr, {{"index", 0}, {"texCoord", 1}, {"scale", 0.5}}, 1, true, {6, 6}, {6, 6}},
};
INSTANTIATE_TEST_SUITE_P(All, GltfNormalMapTest, testing::ValuesIn(normalMaps));

TEST(GltfNormalMapTest, OtherPrimitivesKeepTheirs) {
    SmallGltf gltf = texturedGltf({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    json second = gltf.json["meshes"][0]["primitives"][0];
    gltf.json["materials"].push_back({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}},
                                      {"normalTexture", {{"index", 0}, {"texCoord", 1}}}});
    second["material"] = gltf.json["materials"].size() - 1;
    json third = gltf.json["meshes"][0]["primitives"][0];
    gltf.json["meshes"][0]["primitives"].push_back(second);
    gltf.json["meshes"][0]["primitives"].push_back(third);
    const Mesh mesh = load(gltf);
    ASSERT_EQ(mesh.normalUvs.size(), 9u);
    EXPECT_EQ(mesh.normalUvs[1], mesh.uvs[1]);
    EXPECT_EQ(mesh.normalUvs[4], glm::vec2(6, 6));
    EXPECT_EQ(mesh.normalUvs[7], mesh.uvs[7]);
}

std::string bigEndian(std::uint32_t value, int bytes) {
    std::string text;
    for (int i = bytes - 1; i >= 0; --i)
        text += static_cast<char>(value >> (8 * i));
    return text;
}

std::string pngHeader(std::uint32_t width, std::uint32_t height) {
    return std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16) + bigEndian(width, 4) + bigEndian(height, 4);
}

/// With a comment in front of the frame.
std::string jpegHeader(std::uint32_t width, std::uint32_t height) {
    return std::string("\xff\xd8\xff\xfe\0\x04hm\xff\xff\xc2\0\x11\x08", 14) + bigEndian(height, 2) +
           bigEndian(width, 2) + std::string(8, '\0');
}

std::optional<glm::ivec2> sizeOf(const std::string& bytes) {
    return pictureSize({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

TEST(GltfPictureSizeTest, IsReadFromTheHeaders) {
    EXPECT_EQ(sizeOf(pngHeader(3, 70000)), glm::ivec2(3, 70000));
    EXPECT_EQ(sizeOf(jpegHeader(300, 65535)), glm::ivec2(300, 65535));
    EXPECT_EQ(sizeOf("GIF89a\1\0\1\0"), std::nullopt);
    for (const std::string& whole : {pngHeader(3, 7), jpegHeader(3, 7)})
        for (std::size_t length = 0; length < 18; ++length)
            EXPECT_EQ(sizeOf(whole.substr(0, length)), std::nullopt) << length;
}

TEST(GltfPictureSizeTest, PicturesThatAreTooLargeCostTheTextureBeforeTheyAreDecoded) {
    const std::pair<std::string, const char*> cases[] = {
        {pngHeader(16385, 1), "texture left out: it has 16385 x 1 pixels, not 1 to 16384 on a side"},
        {pngHeader(0, 1), "texture left out: it has 0 x 1 pixels"},
        {jpegHeader(20000, 20000), "texture left out: it has 20000 x 20000 pixels"},
        {"BM not a picture of glTF", "texture left out: it is neither PNG nor JPEG"},
        {pngHeader(16384, 16384), "texture left out: "}}; // of just the size, but that is all there is
    for (const auto& [bytes, warning] : cases) {
        SmallGltf gltf = texturedGltf({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
        gltf.json["images"][0] = {{"mimeType", "image/png"},
                                  {"bufferView", gltf.addView(bytes.data(), bytes.size())}};
        const Mesh mesh = load(gltf);
        EXPECT_EQ(mesh.materials[0].baseColorImage, -1);
        ASSERT_FALSE(mesh.notices.empty());
        EXPECT_THAT(mesh.notices[0], HasSubstr(warning));
    }
}

} // namespace
} // namespace limpid::io
