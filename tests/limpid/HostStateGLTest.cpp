// A host's OpenGL state is its own through every public call, with its own buffers and water too.
#include <gmock/gmock.h>

#include "engine/HostileStates.h"
#include "engine/Scenes.h"
#include "engine/StateDump.h"
#include "gl/Context.h"
#include "limpid/Caustics.h"
#include "limpid/HostData.h"

namespace limpid {
namespace {

std::vector<float> resultOf(const Scene& scene) {
    Caustics caustics(Context::current());
    caustics.set(scene);
    caustics.update(0);
    caustics.maps();
    std::vector<float> result = caustics.irradiance(1);
    const Picture picture = caustics.render(0.1, {16, 12});
    result.insert(result.end(), picture.rgb.begin(), picture.rgb.end());
    return result;
}

TEST(HostStateGLTest, isTheSameAfterEveryCallAndChangesNoBit) {
    const gl::Context hosts;
    const test::HostTexture heights;
    heights.fill([](double x, double z) { return 0.01 * std::sin(7 * x + 5 * z); });
    const Mesh sphere = makeSphere(0.3, glm::vec3(0.8f), 16);
    test::HostBuffers buffers(sphere, 4);
    buffers.mesh().walls = true;
    Scene scene;
    scene.receivers = {scenes::floorAt(-0.8), receiverOf("ball", buffers.mesh())};
    scene.receivers[1].translation.y = -0.4;
    scene.lights = {scenes::sunAt(20)};
    scene.water.grid = {24, 24};
    scene.water.waves = {scenes::cosine(0.002, 0.3, {1, 0}), waveOf(heights.water())};
    scene.caustics.mapSize = 32;
    const std::vector<float> clean = resultOf(scene);
    const HostObjects objects;
    const std::vector<Hostile> states = hostileStates(objects);
    for (const Hostile& state : states)
        state.set();
    const StateDump before = dumpState();
    EXPECT_TRUE(resultOf(scene) == clean);
    const StateDump after = dumpState();
    for (const auto& [name, values] : before)
        EXPECT_EQ(values, after.at(name)) << name;
    for (auto state = states.rbegin(); state != states.rend(); ++state)
        state->end();
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

} // namespace
} // namespace limpid
