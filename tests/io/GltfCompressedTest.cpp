#include <algorithm>
#include <functional>

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include "io/SmallGltf.h"
#include "io/TempFolder.h"
#include "io/gltf/Gltf.h"

namespace limpid::io {
namespace {

using nlohmann::json;
using test::errorOf;
using test::SmallGltf;
using test::TempFolder;
using test::trianglePositions;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// Both ways to write a file: compression changes what must be done to either.
std::vector<Mesh> loadBoth(const SmallGltf& gltf) {
    const TempFolder folder;
    return {loadGltf(folder.write("model.gltf", gltf.text())),
            loadGltf(folder.write("model.glb", gltf.glb()))};
}

std::string loadError(const SmallGltf& gltf) {
    const TempFolder folder;
    const auto file = folder.write("model.gltf", gltf.text());
    return errorOf(folder, [&] { loadGltf(file); });
}

// Draco

/// The triangle with texture coordinates of unsigned bytes.
std::string dracoTriangle(int method) {
    draco::TriangleSoupMeshBuilder builder;
    builder.Start(1);
    const int position = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
    const int uv = builder.AddAttribute(draco::GeometryAttribute::TEX_COORD, 2, draco::DT_UINT8);
    const float* p = trianglePositions.data();
    const std::uint8_t uvs[] = {0, 0, 255, 0, 0, 51};
    builder.SetAttributeValuesForFace(position, draco::FaceIndex(0), p, p + 3, p + 6);
    builder.SetAttributeValuesForFace(uv, draco::FaceIndex(0), uvs, uvs + 2, uvs + 4);
    draco::Encoder encoder;
    encoder.SetEncodingMethod(method);
    draco::EncoderBuffer buffer;
    EXPECT_TRUE(encoder.EncodeMeshToBuffer(*builder.Finalize(), &buffer).ok());
    return {buffer.data(), buffer.size()};
}

json& dracoObject(SmallGltf& gltf) {
    return gltf.json["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"];
}

SmallGltf dracoGltf(const std::string& stream) {
    SmallGltf gltf;
    gltf.json["extensionsUsed"] = gltf.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    const int positions = gltf.addAccessor({{"componentType", 5126}, {"count", 3}, {"type", "VEC3"}});
    const int uvs =
        gltf.addAccessor({{"componentType", 5121}, {"count", 3}, {"type", "VEC2"}, {"normalized", true}});
    const int indices = gltf.addAccessor({{"componentType", 5125}, {"count", 3}, {"type", "SCALAR"}});
    gltf.addMesh({{"attributes", {{"POSITION", positions}, {"TEXCOORD_0", uvs}}}, {"indices", indices}});
    dracoObject(gltf) = {{"bufferView", gltf.addView(stream.data(), stream.size())},
                         {"attributes", {{"POSITION", 0}, {"TEXCOORD_0", 1}}}};
    return gltf;
}

TEST(GltfDracoTest, AttributesAndIndicesComeOutOfTheStream) {
    for (const int method : {draco::MESH_EDGEBREAKER_ENCODING, draco::MESH_SEQUENTIAL_ENCODING})
        for (const Mesh& mesh : loadBoth(dracoGltf(dracoTriangle(method)))) {
            ASSERT_EQ(mesh.triangleCount(), 1u);
            std::vector<std::pair<glm::dvec3, glm::vec2>> vertices;
            for (const std::uint32_t i : mesh.indices)
                vertices.emplace_back(mesh.positions[i], mesh.uvs[i]);
            // It may begin with any corner.
            const auto first = std::find_if(vertices.begin(), vertices.end(),
                                            [](const auto& v) { return v.first == glm::dvec3(0); });
            std::rotate(vertices.begin(), first, vertices.end());
            EXPECT_THAT(vertices, ElementsAre(std::pair(glm::dvec3(0), glm::vec2(0)),
                                              std::pair(glm::dvec3(1, 0, 0), glm::vec2(1, 0)),
                                              std::pair(glm::dvec3(0, 1, 0), glm::vec2(0, 0.2f))));
            EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1));
        }
}

TEST(GltfDracoTest, NoStreamThatIsCutOrChangedDoesHarm) {
    const std::string whole = dracoTriangle(draco::MESH_EDGEBREAKER_ENCODING);
    for (std::size_t length = 0; length < whole.size(); ++length) {
        const std::string error = loadError(dracoGltf(whole.substr(0, length) + std::string(1, '\0')));
        // The end may be cut without loss, where it only fills the last byte.
        if (length < whole.size() / 2) {
            EXPECT_THAT(error, HasSubstr("meshes[0].primitives[0]")) << length;
        }
        EXPECT_THAT(error, Not(HasSubstr("\n")));
    }
    for (std::size_t at = 0; at < whole.size(); ++at)
        for (const int bit : {0, 3, 7}) {
            std::string changed = whole;
            changed[at] = static_cast<char>(changed[at] ^ 1 << bit);
            EXPECT_THAT(loadError(dracoGltf(changed)), Not(HasSubstr("\n")));
        }
}

struct BrokenCase {
    const char* name;
    std::function<void(SmallGltf&)> breakIt;
    const char* error; ///< what the message starts with, after "model.gltf: "
};

std::ostream& operator<<(std::ostream& out, const BrokenCase& c) {
    return out << c.name;
}

class GltfDracoErrorsTest : public testing::TestWithParam<BrokenCase> {};

TEST_P(GltfDracoErrorsTest, NamesPlaceExpectedAndFound) {
    SmallGltf gltf = dracoGltf(dracoTriangle(draco::MESH_EDGEBREAKER_ENCODING));
    GetParam().breakIt(gltf);
    EXPECT_THAT(loadError(gltf), StartsWith(std::string("model.gltf: ") + GetParam().error));
}

const std::string hugeDraco("DRACO\2\2\1\1\0\0" // a mesh by Edgebreaker
                            "\0\xff\xff\xff\xff\x0f\xff\xff\xff\xff\x0f",
                            22);

#define DRACO_PLACE "meshes[0].primitives[0].KHR_draco_mesh_compression"
const BrokenCase dracoErrors[] = {
    {"no view", [](SmallGltf& g) { dracoObject(g).erase("bufferView"); },
     DRACO_PLACE ".bufferView: expected an index below 1, found -1"},
    {"view", [](SmallGltf& g) { dracoObject(g)["bufferView"] = 7; },
     DRACO_PLACE ".bufferView: expected an index below 1, found 7"},
    {"stream", [](SmallGltf& g) { g.bytes.assign(g.bytes.size(), 'x'); },
     DRACO_PLACE ": expected a Draco mesh of version 2.2, found "},
    {"faces without number",
     [](SmallGltf& g) { dracoObject(g)["bufferView"] = g.addView(hugeDraco.data(), hugeDraco.size()); },
     DRACO_PLACE ": expected at most "},
    {"attribute", [](SmallGltf& g) { dracoObject(g)["attributes"]["POSITION"] = 5; },
     "meshes[0].primitives[0].attributes.POSITION: expected an attribute of the Draco mesh, found id 5"},
    {"attribute of another kind", [](SmallGltf& g) { dracoObject(g)["attributes"]["POSITION"] = 1; },
     "meshes[0].primitives[0].attributes.POSITION: expected 3 components, as its accessor has, found 2"},
    {"attribute's accessor",
     [](SmallGltf& g) { g.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = 9; },
     "meshes[0].primitives[0].attributes.POSITION: expected an index below 3, found 9"},
};
INSTANTIATE_TEST_SUITE_P(All, GltfDracoErrorsTest, testing::ValuesIn(dracoErrors));

// meshopt

std::string encodedVertices(const void* data, std::size_t count, std::size_t size) {
    std::string stream(meshopt_encodeVertexBufferBound(count, size), '\0');
    stream.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(stream.data()), stream.size(),
                                             data, count, size));
    return stream;
}

std::string encodedTriangles(const std::vector<std::uint32_t>& indices) {
    std::string stream(meshopt_encodeIndexBufferBound(indices.size(), 3), '\0');
    stream.resize(meshopt_encodeIndexBuffer(reinterpret_cast<unsigned char*>(stream.data()), stream.size(),
                                            indices.data(), indices.size()));
    return stream;
}

/// Adds a view of buffer 1, which exists only once it is decompressed.
int addStream(SmallGltf& gltf, const std::string& stream, std::size_t count, std::size_t stride,
              const char* mode, const char* filter = "NONE") {
    const int view = gltf.addView(stream.data(), stream.size());
    json& object = gltf.json["bufferViews"][view];
    json extension = object;
    extension.update({{"count", count}, {"byteStride", stride}, {"mode", mode}, {"filter", filter}});
    object = {{"buffer", 1},
              {"byteLength", count * stride},
              {"extensions", {{"EXT_meshopt_compression", extension}}}};
    return view;
}

SmallGltf meshoptGltf() {
    SmallGltf gltf;
    gltf.otherBuffers = {
        {{"byteLength", 4000}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}};
    gltf.json["extensionsUsed"] = gltf.json["extensionsRequired"] = {"EXT_meshopt_compression"};
    const int positions =
        addStream(gltf, encodedVertices(trianglePositions.data(), 3, 12), 3, 12, "ATTRIBUTES");
    const int indices = addStream(gltf, encodedTriangles({0, 1, 2}), 3, 2, "TRIANGLES");
    std::vector<signed char> octahedral = {0, 0, 127, 0, 127, 0, 127, 0, 0, -127, 127, 0};
    const int normals =
        addStream(gltf, encodedVertices(octahedral.data(), 3, 4), 3, 4, "ATTRIBUTES", "OCTAHEDRAL");
    gltf.json["bufferViews"][normals]["byteStride"] = 4;
    const auto accessor = [&](int view, int type, const char* shape) {
        return gltf.addAccessor(
            {{"bufferView", view}, {"componentType", type}, {"count", 3}, {"type", shape}});
    };
    const int normalAccessor = accessor(normals, 5120, "VEC3");
    gltf.json["accessors"][normalAccessor]["normalized"] = true;
    gltf.addMesh(
        {{"attributes", {{"POSITION", accessor(positions, 5126, "VEC3")}, {"NORMAL", normalAccessor}}},
         {"indices", accessor(indices, 5123, "SCALAR")}});
    return gltf;
}

TEST(GltfMeshoptTest, ViewsComeOutOfTheirStreams) {
    for (const Mesh& mesh : loadBoth(meshoptGltf())) {
        EXPECT_THAT(mesh.positions, ElementsAre(glm::dvec3(0), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)));
        EXPECT_THAT(mesh.normals, ElementsAre(glm::vec3(0, 0, 1), glm::vec3(1, 0, 0), glm::vec3(0, -1, 0)));
    }
}

TEST(GltfMeshoptTest, NoStreamThatIsChangedDoesHarm) {
    const SmallGltf good = meshoptGltf();
    for (std::size_t at = 0; at < good.bytes.size(); ++at)
        for (const int bit : {0, 3, 7}) {
            SmallGltf changed = good;
            changed.bytes[at] = static_cast<char>(changed.bytes[at] ^ 1 << bit);
            EXPECT_THAT(loadError(changed), Not(HasSubstr("\n")));
        }
}

class GltfMeshoptErrorsTest : public testing::TestWithParam<BrokenCase> {};

TEST_P(GltfMeshoptErrorsTest, NamesPlaceExpectedAndFound) {
    SmallGltf gltf = meshoptGltf();
    GetParam().breakIt(gltf);
    EXPECT_THAT(loadError(gltf), StartsWith(std::string("model.gltf: ") + GetParam().error));
}

json& stream(SmallGltf& gltf, int view = 0) {
    return gltf.json["bufferViews"][view]["extensions"]["EXT_meshopt_compression"];
}

#define MESHOPT_PLACE(i) "bufferViews[" i "].EXT_meshopt_compression"
const BrokenCase meshoptErrors[] = {
    {"buffer", [](SmallGltf& g) { stream(g)["buffer"] = 2; },
     MESHOPT_PLACE("0") ".buffer: expected an index below 2, found 2"},
    {"negative offset", [](SmallGltf& g) { stream(g)["byteOffset"] = -4; },
     MESHOPT_PLACE("0") ".byteOffset: expected a whole number >= 0, found something else"},
    {"range", [](SmallGltf& g) { stream(g)["byteLength"] = 100000; },
     MESHOPT_PLACE("0") ": expected a range inside of its buffer's "},
    {"length", [](SmallGltf& g) { stream(g)["byteLength"] = 5; },
     MESHOPT_PLACE("0") ": expected a stream of version 0 with 3 elements, found 5 bytes that are none"},
    {"version", [](SmallGltf& g) { g.bytes[0] = '\xa1'; },
     MESHOPT_PLACE("0") ": expected a stream of version 0 with 3 elements, found "},
    {"elements without number", [](SmallGltf& g) { stream(g)["count"] = 2000000000; },
     MESHOPT_PLACE("0") ": expected at most "},
    {"mode", [](SmallGltf& g) { stream(g)["mode"] = "POINTS"; },
     MESHOPT_PLACE("0") ".mode: expected ATTRIBUTES, TRIANGLES, INDICES, found \"POINTS\""},
    {"filter", [](SmallGltf& g) { stream(g)["filter"] = "BLUR"; },
     MESHOPT_PLACE("0") ".filter: expected NONE, OCTAHEDRAL, QUATERNION, EXPONENTIAL, COLOR, found \"BLUR\""},
    {"filter of indices", [](SmallGltf& g) { stream(g, 1)["filter"] = "EXPONENTIAL"; },
     MESHOPT_PLACE("1") ".filter: expected NONE, found \"EXPONENTIAL\""},
    {"filter's stride", [](SmallGltf& g) { stream(g)["filter"] = "QUATERNION"; },
     MESHOPT_PLACE("0") ".byteStride: expected 8 for its filter, found 12"},
    {"stride", [](SmallGltf& g) { stream(g)["byteStride"] = 260; },
     MESHOPT_PLACE("0") ".byteStride: expected a multiple of 4 from 4 to 256, found 260"},
    {"index stride", [](SmallGltf& g) { stream(g, 1)["byteStride"] = 1; },
     MESHOPT_PLACE("1") ".byteStride: expected 2 or 4 for indices, found 1"},
    {"incomplete triangle", [](SmallGltf& g) { stream(g, 1)["count"] = 4; },
     MESHOPT_PLACE("1") ".count: expected a multiple of 3, found 4"},
    {"accessor beyond the stream", [](SmallGltf& g) { g.json["accessors"][1]["count"] = 4; },
     "accessors[1].count: expected at most 3, as its buffer view ends there, found 4"},
};
INSTANTIATE_TEST_SUITE_P(All, GltfMeshoptErrorsTest, testing::ValuesIn(meshoptErrors));

} // namespace
} // namespace limpid::io
