// A host that embeds the engine has its own OpenGL state: whatever it is, maps and pictures are the same
// bits, and afterwards it is as it was.
#include "gl/Guard.h"

#include "core/Error.h"
#include "engine/EngineFixture.h"
#include "engine/HostileStates.h"
#include "engine/StateDump.h"

namespace limpid {

namespace {

/// All that an engine gives of a scene.
struct Result {
    std::vector<float> numbers;
    void add(const std::vector<float>& more) { numbers.insert(numbers.end(), more.begin(), more.end()); }
};

class GuardGLTest : public EngineGLTest {
  protected:
    GuardGLTest() {
        scene.receivers = {scenes::floorAt(-0.6),
                           scenes::shape("ball", makeSphere(0.3, glm::vec3(0.8f)), {0, -0.1, 0})};
        scene.lights = {scenes::sunAt(30), scenes::pointLightAt({0.2, 1.5, 0.1})};
        scene.water.grid = {24, 24};
        scene.water.waves = {scenes::cosine(0.01, 0.5, {1, 0.3})};
        scene.water.scattering = glm::dvec3(0.2);
        scene.caustics.mapSize = 32;
        scene.caustics.planes = 4;
        scene.camera.position = {0.4, -0.2, 0.9};
        scene.camera.target = {0, -0.3, 0};
    }

    /// In the tests' own context as if a host had made it.
    static Engine& hostsEngine() {
        static gl::Context host((context(), gl::Context::Current{}), {});
        static Engine instance(host);
        return instance;
    }

    /// Of the engine anew: nothing comes from before the state was set.
    static Result resultOf(Engine& engine, const Scene& scene) {
        Result result;
        engine.set(scene);
        result.add(engine.render(0, {20, 12}).rgb);
        engine.updateCaustics(0);
        for (const MapWork& maps : engine.maps()) {
            const gl::Texture coverage = engine.coverage(maps);
            const MapData data = readMaps(maps, engine.origin(), &coverage);
            result.add(data.irradiance);
            result.add(data.normal);
            result.add(data.coverage);
        }
        return result;
    }

    /// Differences, name by name.
    static std::string difference(const StateDump& before, const StateDump& after) {
        std::string text;
        for (const auto& [name, values] : before)
            if (values != after.at(name)) text += " " + name;
        return text;
    }

    Scene scene;
};

TEST_F(GuardGLTest, noStateOfAHostChangesABitAndNoneIsChanged) {
    const HostObjects objects;
    Engine& engine = hostsEngine();
    scene.water.scattering = glm::dvec3(0);
    scene.lights.pop_back();
    const Result clean = resultOf(engine, scene);
    const std::vector<Hostile> states = hostileStates(objects);
    EXPECT_GE(states.size(), 20u);
    for (const Hostile& state : states) {
        SCOPED_TRACE(state.name);
        state.set();
        const StateDump before = dumpState();
        const bool same = resultOf(engine, scene).numbers == clean.numbers;
        EXPECT_TRUE(same);
        EXPECT_EQ(difference(before, dumpState()), "");
        state.end();
        EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    }
}

TEST_F(GuardGLTest, allOfThemAtOnceByOtherMethodsAndGodrays) {
    const HostObjects objects;
    Engine& engine = hostsEngine();
    // Most of what draws: planes, slices, stencil, layers and lines. The others compute.
    const std::pair<Method, GodrayMethod> kinds[] = {{Method::Volumetric, GodrayMethod::PhotonLines},
                                                     {Method::Stencil, GodrayMethod::Tetrahedra}};
    scene.caustics.fill = Fill::Drawn;
    for (const auto& [method, godrays] : kinds) {
        scene.caustics.method = method;
        scene.godrays.method = godrays;
        const Result clean = resultOf(engine, scene);
        const std::vector<Hostile> states = hostileStates(objects);
        for (const Hostile& state : states)
            state.set();
        const StateDump before = dumpState();
        const bool same = resultOf(engine, scene).numbers == clean.numbers;
        EXPECT_TRUE(same) << int(method) << " " << int(godrays);
        EXPECT_EQ(difference(before, dumpState()), "");
        for (auto state = states.rbegin(); state != states.rend(); ++state)
            state->end();
    }
}

TEST_F(GuardGLTest, onlyTheOutermostActs) {
    gl::Context host(gl::Context::Current{}, {});
    glEnable(GL_CULL_FACE);
    {
        const gl::Guard outer(host);
        EXPECT_FALSE(glIsEnabled(GL_CULL_FACE));
        glEnable(GL_DEPTH_CLAMP);
        {
            const gl::Guard inner(host);
            EXPECT_TRUE(glIsEnabled(GL_DEPTH_CLAMP)) << "what a pass has set within a pass";
        }
        EXPECT_FALSE(glIsEnabled(GL_CULL_FACE));
    }
    EXPECT_TRUE(glIsEnabled(GL_CULL_FACE));
    EXPECT_FALSE(glIsEnabled(GL_DEPTH_CLAMP));
    glDisable(GL_CULL_FACE);
}

TEST_F(GuardGLTest, aProgramDeletedWhileInUseIsNotAskedForAgain) {
    Engine& engine = hostsEngine();
    scene.water.scattering = glm::dvec3(0);
    scene.lights.pop_back();
    const GLuint program = HostObjects::makeProgram();
    glUseProgram(program);
    glDeleteProgram(program);
    engine.set(scene);
    engine.updateCaustics(0);
    GLint used = -1;
    glGetIntegerv(GL_CURRENT_PROGRAM, &used);
    EXPECT_EQ(used, 0);
}

TEST_F(GuardGLTest, isBackAfterAnError) {
    gl::Context host(gl::Context::Current{}, {});
    Engine engine(host);
    glEnable(GL_CULL_FACE);
    host.ledger().setLimit(1000);
    EXPECT_THROW(engine.set(scene), GraphicsError);
    EXPECT_TRUE(glIsEnabled(GL_CULL_FACE));
    glDisable(GL_CULL_FACE);
}

} // namespace
} // namespace limpid
