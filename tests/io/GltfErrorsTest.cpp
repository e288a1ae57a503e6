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
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::string loadError(const std::string& content) {
    const TempFolder folder;
    const auto file = folder.write("model.gltf", content);
    return errorOf(folder, [&] { loadGltf(file); });
}

struct BrokenCase {
    const char* name;
    std::function<void(SmallGltf&)> breakIt; ///< a good triangle with indices
    const char* error;                       ///< what the message starts with, after "model.gltf: "
};

std::ostream& operator<<(std::ostream& out, const BrokenCase& c) {
    return out << c.name;
}

class GltfErrorsTest : public testing::TestWithParam<BrokenCase> {};

TEST_P(GltfErrorsTest, NamesPlaceExpectedAndFoundInOneLine) {
    SmallGltf gltf = triangleGltf();
    gltf.json["meshes"][0]["primitives"][0]["indices"] = gltf.add<std::uint8_t>("SCALAR", {0, 1, 2});
    ASSERT_EQ(loadError(gltf.text()), "no error");
    GetParam().breakIt(gltf);
    const std::string error = loadError(gltf.text());
    EXPECT_THAT(error, StartsWith(std::string("model.gltf: ") + GetParam().error));
    EXPECT_THAT(error, Not(HasSubstr("\n")));
}

json& accessor(SmallGltf& gltf, int i = 0) {
    return gltf.json["accessors"][i];
}
json& view(SmallGltf& gltf, int i = 0) {
    return gltf.json["bufferViews"][i];
}
json& primitive(SmallGltf& gltf) {
    return gltf.json["meshes"][0]["primitives"][0];
}

/// Makes accessor 0 sparse with these indices and one value for each.
void makeSparse(SmallGltf& gltf, const std::vector<std::uint8_t>& indices) {
    const std::vector<float> values(3 * indices.size());
    accessor(gltf)["sparse"] = {
        {"count", indices.size()},
        {"indices", {{"bufferView", gltf.addView(indices.data(), indices.size())}, {"componentType", 5121}}},
        {"values", {{"bufferView", gltf.addView(values.data(), 4 * values.size())}}}};
}

const BrokenCase ranges[] = {
    {"accessor beyond the end", [](SmallGltf& g) { accessor(g)["count"] = 4; },
     "accessors[0].count: expected at most 3, as its buffer view ends there, found 4"},
    {"huge count", [](SmallGltf& g) { accessor(g)["count"] = 18446744073709551615u; },
     "accessors[0].count: expected at most 3, as its buffer view ends there, found 18446744073709551615"},
    {"offset beyond the end", [](SmallGltf& g) { accessor(g)["byteOffset"] = 37; },
     "accessors[0].byteOffset: expected at most 36, found 37"},
    {"offset too close to the end", [](SmallGltf& g) { accessor(g)["byteOffset"] = 4; },
     "accessors[0].count: expected at most 2, as its buffer view ends there, found 3"},
    {"stride below the element's size", [](SmallGltf& g) { view(g)["byteStride"] = 4; },
     "accessors[0].bufferView: expected a byteStride of at least 12, found 4"},
    {"stride too wide", [](SmallGltf& g) { view(g)["byteStride"] = 16; },
     "accessors[0].count: expected at most 2, as its buffer view ends there, found 3"},
    {"view beyond its buffer", [](SmallGltf& g) { view(g)["byteLength"] = 1000; },
     "bufferViews[0]: expected a range inside of its buffer's 39 bytes, found 1000 bytes from 0"},
    {"view offset that overflows", [](SmallGltf& g) { view(g)["byteOffset"] = 18446744073709551615u; },
     "bufferViews[0]: expected a range inside of its buffer's 39 bytes, found 36 bytes from "
     "18446744073709551615"},
    {"zeros without end",
     [](SmallGltf& g) { accessor(g).erase("bufferView"), accessor(g)["count"] = 4000000000u; },
     "accessors[0].count: expected at most "},
    {"index out of range", [](SmallGltf& g) { g.bytes[38] = 7; },
     "meshes[0].primitives[0].indices[2]: expected an index below 3, found 7"},
    {"no number", [](SmallGltf& g) { g.bytes.replace(12, 4, "\x00\x00\xc0\x7f", 4); },
     "meshes[0].primitives[0].attributes.POSITION[1]: expected finite coordinates of at most 1e+09 m, "
     "found "},
    {"infinity", [](SmallGltf& g) { g.bytes.replace(16, 4, std::string("\x00\x00\x80\x7f", 4)); },
     "meshes[0].primitives[0].attributes.POSITION[1]: expected finite coordinates of at most 1e+09 m, "
     "found "},
    {"normals missing at the end",
     [](SmallGltf& g) {
         primitive(g)["attributes"]["NORMAL"] = g.add<float>("VEC3", {0, 0, 1});
     },
     "meshes[0].primitives[0].attributes.NORMAL: expected 3 elements, as POSITION has, found 1"},
    {"sparse index out of range", [](SmallGltf& g) { makeSparse(g, {3}); },
     "accessors[0].sparse.indices[0]: expected an index below 3, found 3"},
    {"sparse indices out of order",
     [](SmallGltf& g) {
         makeSparse(g, {1, 1});
     },
     "accessors[0].sparse.indices[1]: expected an index above 1, found 1"},
    {"sparse count", [](SmallGltf& g) { makeSparse(g, {0}), accessor(g)["sparse"]["count"] = -1; },
     "accessors[0].sparse.count: expected a number from 0 to 3, found -1"},
    {"sparse values beyond the end",
     [](SmallGltf& g) { makeSparse(g, {0}), accessor(g)["sparse"]["count"] = 2; },
     "accessors[0].sparse.indices.count: expected at most 1, as its buffer view ends there, found 2"},
    {"sparse offset",
     [](SmallGltf& g) { makeSparse(g, {0}), accessor(g)["sparse"]["values"]["byteOffset"] = -4; },
     "accessors[0].sparse.byteOffset: expected a number >= 0, found -4"},
};

const BrokenCase references[] = {
    {"attribute", [](SmallGltf& g) { primitive(g)["attributes"]["POSITION"] = 9; },
     "meshes[0].primitives[0].attributes.POSITION: expected an index below 2, found 9"},
    {"negative attribute", [](SmallGltf& g) { primitive(g)["attributes"]["POSITION"] = -1; },
     "meshes[0].primitives[0].attributes.POSITION: expected an index below 2, found -1"},
    {"view", [](SmallGltf& g) { accessor(g)["bufferView"] = 9; },
     "accessors[0].bufferView: expected an index below 2, found 9"},
    {"buffer", [](SmallGltf& g) { view(g)["buffer"] = 9; },
     "bufferViews[0].buffer: expected an index below 1, found 9"},
    {"material", [](SmallGltf& g) { primitive(g)["material"] = 0; },
     "meshes[0].primitives[0].material: expected no index, as there is nothing to refer to, found 0"},
    {"mesh", [](SmallGltf& g) { g.json["nodes"][0]["mesh"] = 9; },
     "nodes[0].mesh: expected an index below 1, found 9"},
    {"scene", [](SmallGltf& g) { g.json["scene"] = 0; },
     "scene: expected no index, as there is nothing to refer to, found 0"},
    {"scene node",
     [](SmallGltf& g) {
         g.json["scenes"] = {{{"nodes", {9}}}};
     },
     "scenes[0].nodes[0]: expected an index below 1, found 9"},
    {"child", [](SmallGltf& g) { g.json["nodes"][0]["children"] = {9}; },
     "nodes[0].children[0]: expected an index below 1, found 9"},
    {"texture",
     [](SmallGltf& g) {
         primitive(g)["material"] = 0;
         g.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 3}}}}}}};
     },
     "materials[0].pbrMetallicRoughness.baseColorTexture.index: expected no index, as there is nothing to "
     "refer to, "
     "found 3"},
    {"index type", [](SmallGltf& g) { accessor(g, 1)["componentType"] = 5120; },
     "accessors[1]: expected scalars of 8, 16 or 32 bits without sign for meshes[0].primitives[0].indices, "
     "found "
     "SCALAR of component type 5120"},
    {"position type", [](SmallGltf& g) { accessor(g)["type"] = "VEC2"; },
     "accessors[0]: expected vectors of 3 floats, or of 3 integers of 8 or 16 bits for "
     "meshes[0].primitives[0].attributes.POSITION, found VEC2 of component type 5126"},
};

const BrokenCase structure[] = {
    {"cycle",
     [](SmallGltf& g) {
         g.json["nodes"] = {{{"mesh", 0}, {"children", {1}}}, {{"children", {0}}}};
     },
     "nodes[0]: expected nodes without a cycle, found a node that is its own ancestor"},
    {"own child", [](SmallGltf& g) { g.json["nodes"][0]["children"] = {0}; },
     "nodes[0]: expected nodes without a cycle"},
    {"two parents",
     [](SmallGltf& g) {
         g.json["nodes"] = {{{"mesh", 0}}, {{"children", {0}}}, {{"children", {0}}}};
     },
     "nodes[2].children[0]: expected a node without another parent, found nodes[0], a child of nodes[1]"},
    {"scene of a child",
     [](SmallGltf& g) {
         g.json["nodes"] = {{{"mesh", 0}}, {{"children", {0}}}};
         g.json["scenes"] = {{{"nodes", {0}}}};
     },
     "scenes[0].nodes[0]: expected a root node, found nodes[0], a child of nodes[1]"},
    {"node twice",
     [](SmallGltf& g) {
         g.json["scenes"] = {{{"nodes", {0, 0}}}};
     },
     "scenes[0].nodes[1]: expected a node only once, found nodes[0] again"},
    {"matrix",
     [](SmallGltf& g) {
         g.json["nodes"][0]["matrix"] = {1, 2, 3};
     },
     "nodes[0].matrix: expected 16 numbers, found 3"},
    {"rotation",
     [](SmallGltf& g) {
         g.json["nodes"][0]["rotation"] = {0, 0, 0, 0};
     },
     "nodes[0].rotation: expected a quaternion of length 1, found length 0"},
    {"scale beyond everything",
     [](SmallGltf& g) {
         g.json["nodes"][0]["scale"] = {1e300, 1, 1};
     },
     "meshes[0].primitives[0].attributes.POSITION[1]: expected finite coordinates of at most 1e+09 m, found "
     "1e+300"},
    {"version", [](SmallGltf& g) { g.json["asset"]["version"] = "1.0"; },
     "asset.version: expected 2.0, found \"1.0\""},
    {"no triangles", [](SmallGltf& g) { primitive(g)["mode"] = 1; },
     "scene: expected a mesh with triangles, found no triangles"},
    {"no nodes", [](SmallGltf& g) { g.json.erase("nodes"); },
     "scene: expected a mesh with triangles, found no triangles"},
    {"no asset", [](SmallGltf& g) { g.json.erase("asset"); },
     "glTF: expected a valid file, found an error: "},
    {"buffer length",
     [](SmallGltf& g) {
         g.json["buffers"] = {{{"byteLength", 1e9}, {"uri", "data:application/octet-stream;base64,AAAA"}}};
     },
     "glTF: expected a valid file, found an error: "},
};

const BrokenCase files[] = {
    {"parent folder",
     [](SmallGltf& g) {
         g.json["buffers"] = {{{"byteLength", 39}, {"uri", "../a.bin"}}};
     },
     "buffers: expected a file inside of the model's folder, found \"../a.bin\""},
    {"parent folder in disguise",
     [](SmallGltf& g) {
         g.json["buffers"] = {{{"byteLength", 39}, {"uri", "a/%2e%2E/..\\a.bin"}}};
     },
     "buffers: expected a file inside of the model's folder, found \"a/../..\\a.bin\""},
    {"absolute",
     [](SmallGltf& g) {
         g.json["buffers"] = {{{"byteLength", 39}, {"uri", "/etc/passwd"}}};
     },
     "buffers: expected a file inside of the model's folder, found \"/etc/passwd\""},
    {"scheme",
     [](SmallGltf& g) {
         g.json["buffers"] = {{{"byteLength", 39}, {"uri", "file:///etc/passwd"}}};
     },
     "buffers: expected a file inside of the model's folder, found \"file:///etc/passwd\""},
    {"missing",
     [](SmallGltf& g) {
         g.json["buffers"] = {{{"byteLength", 39}, {"uri", "none.bin"}}};
     },
     "glTF: expected a valid file, found an error: File not found : none.bin"},
};

INSTANTIATE_TEST_SUITE_P(Ranges, GltfErrorsTest, testing::ValuesIn(ranges));
INSTANTIATE_TEST_SUITE_P(References, GltfErrorsTest, testing::ValuesIn(references));
INSTANTIATE_TEST_SUITE_P(Structure, GltfErrorsTest, testing::ValuesIn(structure));
INSTANTIATE_TEST_SUITE_P(Files, GltfErrorsTest, testing::ValuesIn(files));

TEST(GltfContentTest, FilesThatAreNoGltf) {
    EXPECT_EQ(loadError(""), "model.gltf: expected a file, found an empty file");
    for (const char* content : {"{", "[]", "hello\nworld", "null", "{\"asset\": 1}"}) {
        const std::string error = loadError(content);
        EXPECT_THAT(error, StartsWith("model.gltf: glTF: expected a valid file, found an error: "));
        EXPECT_THAT(error, Not(HasSubstr("\n")));
    }
}

TEST(GltfContentTest, NestingThatWouldOverflowTheStack) {
    constexpr std::size_t depth = 200000;
    const std::string nested = std::string(depth, '[') + std::string(depth, ']');
    EXPECT_THAT(loadError("{\"asset\":{\"version\":\"2.0\"},\"extras\":" + nested + "}"),
                StartsWith("model.gltf: JSON: expected at most 200 nested levels, found 200001"));
}

/// Every way to cut a GLB short, and every byte of it changed, ends in an error of one line or loads.
TEST(GltfContentTest, CutAndChangedBinariesNeverCrash) {
    const std::string good = triangleGltf().glb();
    for (std::size_t size = 0; size < good.size(); ++size) {
        const std::string error = loadError(good.substr(0, size));
        EXPECT_THAT(error, StartsWith("model.gltf: "));
        EXPECT_THAT(error, Not(HasSubstr("\n")));
    }
    for (std::size_t i = 0; i < good.size(); ++i) {
        std::string changed = good;
        changed[i] = static_cast<char>(changed[i] ^ 0x15);
        EXPECT_THAT(loadError(changed), Not(HasSubstr("\n"))) << "byte " << i;
    }
}

TEST(GltfContentTest, ABinaryChunkThatReachesBeyondTheFile) {
    std::string glb = triangleGltf().glb();
    const std::size_t header = glb.size() - 36 - 8;
    glb.replace(header, 4, SmallGltf::u32(44));
    EXPECT_EQ(loadError(glb),
              "model.gltf: GLB binary chunk: expected at most 36 bytes, found a length of 44");
}

TEST(GltfRequiredExtensionTest, IsNamedUnlessItIsHonouredOrChangesLooksAlone) {
    const auto errorWith = [](const char* extension) {
        SmallGltf gltf = triangleGltf();
        gltf.json["extensionsRequired"] = {"KHR_materials_unlit", "KHR_materials_transmission", extension};
        return loadError(gltf.text());
    };
    for (const char* extension :
         {"KHR_materials_ior", "KHR_materials_variants", "KHR_materials_emissive_strength",
          "KHR_materials_pbrSpecularGlossiness", "KHR_node_visibility", "KHR_xmp_json_ld"})
        EXPECT_EQ(errorWith(extension), "no error") << extension;
    for (const char* found :
         {"\"KHR_texture_basisu\" (KTX2 pictures are not read)",
          "\"KHR_materials_volume\" (light goes straight through what it goes through)",
          "\"KHR_materials_diffuse_transmission\" (no light is scattered through a surface)",
          "\"KHR_materials_of_tomorrow\" (it is not known)"}) {
        const std::string name(found + 1, std::string_view(found).find('"', 1) - 1);
        const std::string error = errorWith(name.c_str());
        EXPECT_THAT(error,
                    StartsWith("model.gltf: extensionsRequired: expected KHR_draco_mesh_compression, "));
        EXPECT_THAT(error, testing::EndsWith(std::string("found ") + found));
    }
}

} // namespace
} // namespace limpid::io
