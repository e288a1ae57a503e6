// A GPU takes work groups, and the lanes in each, in any order. Software has one; here every compute shader
// is also run in the reverse of it, and the maps must not show which was first.
#include <cstdlib>
#include <regex>

#include <fmt/format.h>

#include "engine/EngineFixture.h"
#include "gl/ShaderLibrary.h"
#include "io/TempFolder.h"
#include "scene/MethodFacts.h"

namespace limpid {
namespace {

/// The compute shaders, and what they include, with the last group and its last lane in the place of the
/// first, while this lives.
class Reversed {
  public:
    Reversed() {
        for (const gl::EmbeddedShader& shader : gl::embeddedShaders())
            if (shader.name.ends_with(".comp") || shader.name.ends_with(".glsl"))
                _folder.write(std::string(shader.name), reversed(std::string(shader.text)));
        setenv("LIMPID_SHADERS", _folder.path().c_str(), 1);
    }
    ~Reversed() { unsetenv("LIMPID_SHADERS"); }
    Reversed(const Reversed&) = delete;
    Reversed& operator=(const Reversed&) = delete;

  private:
    static std::string reversed(std::string text) {
        const std::pair<const char*, const char*> ends[] = {
            {"gl_WorkGroupID", "gl_NumWorkGroups"},
            {"gl_GlobalInvocationID", "gl_NumWorkGroups * gl_WorkGroupSize"},
            {"gl_LocalInvocationID", "gl_WorkGroupSize"},
            {"gl_LocalInvocationIndex", "gl_WorkGroupSize.x * gl_WorkGroupSize.y * gl_WorkGroupSize.z"}};
        for (const auto& [place, end] : ends)
            text = std::regex_replace(text, std::regex(place), fmt::format("({} - 1u - $&)", end));
        // The size of a group has to be known where an include asks for it; it may be said twice.
        const std::regex size(R"(layout\(local_size[^;]*;)");
        std::smatch said;
        if (std::regex_search(text, said, size) && !std::regex_search(said.suffix().str(), size))
            text.insert(0, said.str() + "\n");
        return text;
    }
    test::TempFolder _folder;
};

/// Those whose passes of their own are compute programs; most of this test's time compiles them.
constexpr Method methods[] = {Method::LevelMap, Method::ExactBeam, Method::PhotonSplat};

class OrderGLTest : public EngineGLTest {
  protected:
    /// A ball over a floor, some of its beams wide and some narrow, some shaded.
    static Scene scene(Method method) {
        Scene scene = scenes::floorPastSphere(30);
        scene.water.grid = {48, 48};
        scene.water.waves = {scenes::cosine(0.02, 0.5, {1, 0.3})};
        scene.water.absorption = {0.3, 0.1, 0.05};
        scene.caustics.method = method;
        scene.caustics.fill = Fill::OnePass;
        scene.caustics.mapSize = 64;
        scene.caustics.planes = 8;
        scene.caustics.photonGrid = {40, 40};
        return scene;
    }
};

TEST_F(OrderGLTest, ofWorkGroupsAndLanesChangesNoBitOfAnyMap) {
    std::vector<Baked> first;
    for (const Method method : methods)
        first.push_back(bake(scene(method)));
    const Reversed order;
    Engine reversed(context());
    for (std::size_t i = 0; i < first.size(); ++i) {
        SCOPED_TRACE(methodName(methods[i]));
        const Baked second = bake(reversed, scene(methods[i]));
        ASSERT_EQ(first[i].maps.size(), second.maps.size());
        for (std::size_t m = 0; m < second.maps.size(); ++m) {
            EXPECT_EQ(first[i].maps[m].irradiance, second.maps[m].irradiance);
            EXPECT_EQ(first[i].maps[m].position, second.maps[m].position);
            EXPECT_GT(second.maps[m].deposited, 0);
        }
    }
}

} // namespace
} // namespace limpid
