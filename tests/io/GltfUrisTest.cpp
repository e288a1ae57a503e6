#include "io/gltf/Uris.h"

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

struct UriCase {
    const char* uri;  ///< in the file
    const char* name; ///< on the disk
};

std::ostream& operator<<(std::ostream& out, const UriCase& c) {
    return out << c.uri;
}

class GltfUriTest : public testing::TestWithParam<UriCase> {
  protected:
    /// A triangle whose buffer lies in a file of its own.
    static SmallGltf gltf(const char* uri) {
        SmallGltf result = test::triangleGltf();
        result.json["buffers"] = {{{"byteLength", result.bytes.size()}, {"uri", uri}}};
        return result;
    }
};

TEST_P(GltfUriTest, IsDecodedAsRfc3986Says) {
    const TempFolder folder;
    const SmallGltf model = gltf(GetParam().uri);
    folder.write(GetParam().name, model.bytes);
    EXPECT_EQ(loadGltf(folder.write("model.gltf", model.text())).triangleCount(), 1u);
    EXPECT_EQ(loadGltf(folder.write("model.glb", model.glb())).triangleCount(), 1u);
}

const UriCase uris[] = {
    {"plain.bin", "plain.bin"},
    {"a+b.bin", "a+b.bin"},
    {"a%2Bb%20c+.bin", "a+b c+.bin"},
    {"a b.bin", "a b.bin"},
    {"a%20b.bin", "a b.bin"},
    {"100%25.bin", "100%.bin"},
    {"100%.bin", "100%.bin"}, // no escape, so it can only be meant as it stands
    {"5%of+%C3%A4.bin", "5%of+ä.bin"},
    {"%CF%80.bin", "π.bin"},
    {"プール+.bin", "プール+.bin"},
    {"parts/a+b.bin", "parts/a+b.bin"},
    {"parts\\a+b.bin", "parts\\a+b.bin"},
    {"parts\\a.bin", "parts/a.bin"},
};
INSTANTIATE_TEST_SUITE_P(All, GltfUriTest, testing::ValuesIn(uris));

TEST(GltfUrisTest, OfPicturesLikewise) {
    const TempFolder folder;
    SmallGltf gltf = test::triangleGltf();
    gltf.json["meshes"][0]["primitives"][0]["material"] = 0;
    gltf.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    gltf.json["textures"] = {{{"source", 0}}};
    gltf.json["images"] = {{{"uri", "blue+tiles.png"}}};
    folder.write("blue+tiles.png", "no picture, but found");
    EXPECT_THAT(loadGltf(folder.write("model.gltf", gltf.text())).notices,
                testing::ElementsAre(testing::HasSubstr("it is neither PNG nor JPEG")));
}

TEST(GltfUrisTest, DataStaysAsItIs) {
    EXPECT_EQ(withEscapedUris(R"({"buffers": [{"uri": "data:application/octet-stream;base64,++%+"}]})"),
              std::nullopt);
    EXPECT_EQ(withEscapedUris(R"({"buffers": [{"uri": "a%20b.bin"}]})"), std::nullopt);
    EXPECT_EQ(withEscapedUris(R"(no JSON, "uri": "a+b")"), std::nullopt);
}

TEST(GltfUrisTest, AMissingFileIsNamed) {
    const TempFolder folder;
    SmallGltf gltf = test::triangleGltf();
    gltf.json["buffers"] = {{{"byteLength", gltf.bytes.size()}, {"uri", "a+b.bin"}}};
    const auto file = folder.write("model.gltf", gltf.text());
    EXPECT_THAT(errorOf(folder, [&] { loadGltf(file); }), testing::HasSubstr("a+b.bin"));
}

TEST(GltfUrisTest, AnEscapedWayOutOfTheFolderIsNone) {
    const TempFolder folder;
    folder.write("secret+.bin", "secret");
    for (const char* uri : {"../secret+.bin", "..%2Fsecret+.bin", "..\\secret+.bin"}) {
        SmallGltf gltf = test::triangleGltf();
        gltf.json["buffers"] = {{{"byteLength", 6}, {"uri", uri}}};
        const auto file = folder.write("model/model.gltf", gltf.text());
        EXPECT_THAT(errorOf(folder, [&] { loadGltf(file); }),
                    testing::HasSubstr("expected a file inside of the model's folder"))
            << uri;
    }
}

} // namespace
} // namespace limpid::io
