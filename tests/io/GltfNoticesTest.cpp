#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/SmallGltf.h"
#include "io/TempFolder.h"
#include "io/gltf/Gltf.h"

namespace limpid::io {
namespace {

using nlohmann::json;
using test::SmallGltf;
using test::TempFolder;
using test::triangleGltf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> noticesOf(const SmallGltf& gltf) {
    const TempFolder folder;
    std::vector<std::string> notices = loadGltf(folder.write("fish.gltf", gltf.text())).notices;
    for (std::string& notice : notices)
        notice.erase(0, folder.path().string().size() + 1);
    return notices;
}

json& primitive(SmallGltf& gltf) {
    return gltf.json["meshes"][0]["primitives"][0];
}

TEST(GltfNoticesTest, ThereAreNoneForWhatIsUsedInFull) {
    SmallGltf gltf = triangleGltf();
    gltf.json["extensionsUsed"] = {"KHR_mesh_quantization", "KHR_materials_transmission",
                                   "KHR_materials_emissive_strength", "KHR_node_visibility",
                                   "KHR_texture_transform"};
    gltf.json["scenes"] = {{{"nodes", {0}}}};
    primitive(gltf)["attributes"]["TEXCOORD_0"] = gltf.add<float>("VEC2", {0, 0, 1, 0, 0, 1});
    EXPECT_THAT(noticesOf(gltf), IsEmpty());
}

struct NoticeCase {
    const char* name;
    void (*change)(SmallGltf&);
    std::vector<std::string> notices;
};

std::ostream& operator<<(std::ostream& out, const NoticeCase& c) {
    return out << c.name;
}

class GltfNoticeTest : public testing::TestWithParam<NoticeCase> {};

TEST_P(GltfNoticeTest, NamesWhatIsNotUsedAndWhy) {
    SmallGltf gltf = triangleGltf();
    GetParam().change(gltf);
    EXPECT_EQ(noticesOf(gltf), GetParam().notices);
}

const NoticeCase noticeCases[] = {
    {"extensions",
     [](SmallGltf& g) {
         g.json["extensionsUsed"] = {"KHR_materials_volume", "KHR_materials_sheen", "KHR_materials_clearcoat",
                                     "KHR_materials_dispersion", "EXT_of_tomorrow"};
     },
     {"fish.gltf: extensionsUsed: not used: KHR_materials_clearcoat, KHR_materials_sheen (all surfaces are "
      "drawn "
      "matt)",
      "fish.gltf: extensionsUsed: not used: EXT_of_tomorrow (it is not known)",
      "fish.gltf: extensionsUsed: not used: KHR_materials_dispersion, KHR_materials_volume (light goes "
      "straight "
      "through what it goes through)"}},
    {"animations",
     [](SmallGltf& g) {
         g.json["animations"] = {{{"name", "swim"}, {"channels", json::array()}, {"samplers", json::array()}},
                                 {{"channels", json::array()}, {"samplers", json::array()}}};
     },
     {"fish.gltf: animations: not used: \"swim\", animation 1 (models stand as they are at rest)"}},
    {"scenes",
     [](SmallGltf& g) {
         g.json["scenes"] = {{{"name", "day"}, {"nodes", {0}}}, {{"name", "night"}, {"nodes", {0}}}};
         g.json["scene"] = 1;
     },
     {"fish.gltf: scenes: not used: \"day\" (the file's default scene is shown)"}},
    {"attributes",
     [](SmallGltf& g) {
         const int uvs = g.add<float>("VEC2", {0, 0, 1, 0, 0, 1}),
                   colors = g.add<float>("VEC3", std::vector<float>(9));
         for (const char* name : {"TEXCOORD_0", "TEXCOORD_1"})
             primitive(g)["attributes"][name] = uvs;
         for (const char* name : {"COLOR_0", "COLOR_1", "_WETNESS"})
             primitive(g)["attributes"][name] = colors;
     },
     {"fish.gltf: meshes: not used: _WETNESS (it is the author's own)",
      "fish.gltf: meshes: not used: TEXCOORD_1 (no texture that is drawn lies on it)",
      "fish.gltf: meshes: not used: COLOR_1 (only COLOR_0 is drawn)"}},
    {"points and lines",
     [](SmallGltf& g) {
         for (const int mode : {0, 1, 3})
             g.addMesh({{"attributes", {{"POSITION", 0}}}, {"mode", mode}});
     },
     {"fish.gltf: meshes: not used: lines, points (only triangles are drawn)"}},
    {"textures that make surfaces shine",
     [](SmallGltf& g) {
         primitive(g)["material"] = 0;
         g.json["materials"] = {{{"pbrMetallicRoughness", {{"metallicRoughnessTexture", {{"index", 0}}}}},
                                 {"occlusionTexture", {{"index", 0}}}}};
     },
     {"fish.gltf: materials: not used: metallicRoughnessTexture, occlusionTexture (all surfaces are drawn "
      "matt)"}},
    {"textures of an extension's format",
     [](SmallGltf& g) {
         primitive(g)["material"] = 0;
         g.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}},
                                 {"emissiveTexture", {{"index", 0}}}}};
         g.json["textures"] = {{{"extensions", {{"KHR_texture_basisu", {{"source", 0}}}}}}};
     },
     {"fish.gltf: textures[0]: texture left out: KHR_texture_basisu: KTX2 pictures are not read"}},
    {"a picture that is missing",
     [](SmallGltf& g) {
         primitive(g)["material"] = 0;
         g.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
         g.json["textures"] = {{{"source", 0}}};
         g.json["images"] = {{{"uri", "../blue.png"}}};
     },
     {"fish.gltf: images[0]: texture left out: no file of the model's folder is \"../blue.png\""}},
    {"a picture of another format in the file",
     [](SmallGltf& g) {
         primitive(g)["material"] = 0;
         g.json["materials"] = {{{"emissiveTexture", {{"index", 0}}}}};
         g.json["textures"] = {{{"source", 0}}};
         g.json["images"] = {{{"uri", "data:image/webp;base64,AAAA"}}};
     },
     {"fish.gltf: images[0]: texture left out: it is neither PNG nor JPEG"}},
    {"lamps and cameras",
     [](SmallGltf& g) {
         g.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
         g.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}}};
         g.json["nodes"].push_back(
             {{"name", "Lamp"}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
         g.json["nodes"].push_back({{"name", "Eye"}, {"camera", 0}});
     },
     {"fish.gltf: cameras: not used: \"Eye\" (the scene's own camera stands for it)",
      "fish.gltf: lights: not used: \"Lamp\" (the scene's own lights stand for it)"}},
};
INSTANTIATE_TEST_SUITE_P(All, GltfNoticeTest, testing::ValuesIn(noticeCases));

TEST(GltfNoticesTest, ATextureOnOtherCoordinatesThanTheBaseColorIsLeftOut) {
    SmallGltf gltf = triangleGltf();
    primitive(gltf)["material"] = 0;
    primitive(gltf)["attributes"]["TEXCOORD_1"] = gltf.add<float>("VEC2", {0, 0, 1, 0, 0, 1});
    gltf.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}},
                               {"emissiveTexture", {{"index", 0}, {"texCoord", 1}}}}};
    gltf.json["textures"] = {{{"source", 0}}};
    gltf.json["images"] = {{{"uri", "none.png"}}};
    EXPECT_THAT(noticesOf(gltf),
                testing::Contains("fish.gltf: materials[0].emissiveTexture: texture left out: it lies "
                                  "on other coordinates than "
                                  "materials[0].pbrMetallicRoughness.baseColorTexture"));
}

} // namespace
} // namespace limpid::io
