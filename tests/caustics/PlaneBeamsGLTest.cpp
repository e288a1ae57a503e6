#include <algorithm>
#include <cmath>
#include <map>

#include "caustics/PlaneBeams.h"
#include "engine/EngineFixture.h"

namespace limpid {
namespace {

/// Scenes that between them have all that the pass does: planes and sub-boxes, shade of other receivers,
/// colour, a point light, what stands out of the water, and beams of thousands of texels.
struct PlaneCase {
    const char* name;
    Scene (*scene)();
};

Scene waves(std::vector<Receiver> receivers, double degrees) {
    Scene scene;
    scene.receivers = std::move(receivers);
    scene.lights = {scenes::sunAt(degrees)};
    scene.water.waves = {scenes::cosine(0.006, 0.25, {1, 0.3}), scenes::noise(0.02, 0.4)};
    scene.water.grid = {96, 96};
    scene.caustics.method = Method::LevelMapSmart;
    scene.caustics.mapSize = 128;
    scene.caustics.planes = 17;
    return scene;
}

Scene teapot() {
    return waves({scenes::model("teapot", -1.3)}, 25);
}

Scene shadedFloor() {
    Scene scene = waves({scenes::floorAt(-1.5, 2), scenes::model("fish", -1)}, -35);
    scene.water.absorption = {0.5, 0.2, 0.1};
    return scene;
}

Scene subBoxes() {
    Scene scene = waves({scenes::model("cross", -1.3)}, 10);
    scene.caustics.slicing = Slicing::Levels;
    return scene;
}

Scene pointLight() {
    Scene scene = waves({scenes::model("sphere", -1.2)}, 0);
    scene.lights[0].type = LightType::Point;
    scene.lights[0].position = {0.3, 0.6, -0.2};
    return scene;
}

Scene reef() {
    Scene scene = waves({scenes::model("box", -0.6), scenes::floorAt(-0.8)}, 40);
    scene.water.scattering = glm::dvec3(0.3);
    return scene;
}

/// Light that runs along flanks sweeps over whole maps of theirs, plane after plane.
Scene flanks() {
    Scene scene = waves({scenes::model("fish", -1)}, 20);
    scene.caustics.mapSize = 256;
    scene.water.grid = {48, 48};
    return scene;
}

Scene largeBeams() {
    Scene scene = waves({scenes::model("teapot", -1.3), scenes::floorAt(-1.4)}, 20);
    scene.water.center = glm::dvec2(0);
    scene.water.size = glm::dvec2(6);
    scene.water.grid = {5, 5};
    scene.caustics.mapSize = 256;
    return scene;
}

class PlaneBeamsGLTest : public EngineGLTest, public ::testing::WithParamInterface<PlaneCase> {
  protected:
    static PlaneBeams::Inputs inputsOf(const Engine& engine, const MapWork& maps) {
        return {maps.level,
                maps.depths,
                engine.light(maps.plan.light).beams,
                engine.waterMesh(),
                engine.waterPatch(),
                engine.scene().water,
                engine.scene().lights[std::size_t(maps.plan.light)]};
    }
    static std::vector<float> filled(PlaneBeams& pass, const PlaneBeams::Inputs& inputs,
                                     PlaneBeams::Dispatch dispatch = PlaneBeams::Dispatch::Once) {
        CausticMap caustics;
        pass.fill(caustics, inputs, dispatch);
        return caustics.irradiance.readFloats(GL_RGBA, 4);
    }
};

TEST_P(PlaneBeamsGLTest, givesTheSameBitsPlaneByPlane) {
    Engine engine(context());
    engine.set(GetParam().scene());
    engine.updateCaustics(0);
    PlaneBeams pass(context());
    for (const MapWork& maps : engine.maps()) {
        const PlaneBeams::Inputs inputs = inputsOf(engine, maps);
        const auto once = filled(pass, inputs);
        EXPECT_EQ(once, maps.caustics.irradiance.readFloats(GL_RGBA, 4)) << "the engine's own";
        EXPECT_EQ(once, filled(pass, inputs)) << "a rerun";
        EXPECT_EQ(once, filled(pass, inputs, PlaneBeams::Dispatch::PlaneByPlane));
    }
}

/// The beams of a map as they are cut with its planes, in double precision, texels.
class BeamEdges {
  public:
    BeamEdges(const Engine& engine, const MapWork& maps) : _texel(maps.level.frame.texel) {
        const Beams& beams = engine.light(maps.plan.light).beams;
        const auto origins = beams.origins.read<glm::vec4>(std::size_t(beams.vertexCount));
        const auto directions = beams.directions.read<glm::vec4>(std::size_t(beams.vertexCount));
        _indices = engine.waterMesh().indices.read<std::uint32_t>(3 * std::size_t(beams.triangleCount));
        const OrientedBox& box = maps.level.frame.box;
        for (std::size_t i = 0; i < origins.size(); ++i) {
            const glm::dvec3 o = glm::dvec3(origins[i]) + engine.origin() - box.corner;
            const glm::dvec3 d(directions[i]);
            _origins.emplace_back(glm::dot(o, box.u), glm::dot(o, box.w), glm::dot(o, box.t));
            const double along = std::max(glm::dot(d, box.t), 1e-9);
            _slopes.emplace_back(glm::dot(d, box.u) / along, glm::dot(d, box.w) / along);
        }
    }

    /// How far a texel's centre is from the nearest edge on a plane.
    double distance(const glm::dvec2& centre, double depth) const {
        double least = 1e300;
        for (std::size_t i = 0; i < _indices.size(); ++i) {
            const glm::dvec2 a = at(_indices[i], depth) - centre;
            const glm::dvec2 b = at(_indices[i % 3 == 2 ? i - 2 : i + 1], depth) - centre;
            if (std::min(std::abs(a.x), std::abs(b.x)) > 1 && a.x * b.x > 0) continue;
            const glm::dvec2 ab = b - a;
            const double length = glm::dot(ab, ab);
            const double t = length > 0 ? std::clamp(-glm::dot(a, ab) / length, 0.0, 1.0) : 0.0;
            least = std::min(least, glm::length(a + t * ab));
        }
        return least;
    }

  private:
    glm::dvec2 at(std::uint32_t vertex, double depth) const {
        const glm::dvec3& o = _origins[vertex];
        return (glm::dvec2(o) + (depth - o.z) * _slopes[vertex]) / _texel;
    }
    double _texel;
    std::vector<std::uint32_t> _indices;
    std::vector<glm::dvec3> _origins;
    std::vector<glm::dvec2> _slopes;
};

/// What may differ where both forms take the same beams, of W/m² under lights of 1. A beam's slope is
/// interpolated between corners that a float knows to 1e-5 texel; over a thin beam it changes by up to 2 a
/// texel, and the cosine with it, however dark the face. The rest, sums of floats and steps (2²² for an
/// unfocused texel) and the way in the water, is below 1e-4 of the light.
constexpr double ofUnfocused = 2e-5, ofValue = 1e-4;

double depthOf(const LevelMap& map, float index) {
    for (const ReferencePlane& plane : map.planes)
        if (plane.index == int(index)) return plane.depth;
    ADD_FAILURE() << "no plane " << index;
    return 0;
}

TEST_P(PlaneBeamsGLTest, differsFromTheDrawnFormAtEdgesOnly) {
    Scene scene = GetParam().scene();
    scene.caustics.fill = Fill::Drawn;
    Engine drawing(context()), engine(context());
    drawing.set(scene);
    drawing.updateCaustics(0);
    scene.caustics.fill = Fill::OnePass;
    engine.set(scene);
    engine.updateCaustics(0);
    int texels = 0, differing = 0, wrong = 0;
    double least = 0, worstOff = 0, total = 0;
    for (std::size_t m = 0; m < engine.maps().size(); ++m) {
        const MapWork& maps = engine.maps()[m];
        const auto ours = maps.caustics.irradiance.readFloats(GL_RGBA, 4);
        const auto drawn = drawing.maps()[m].caustics.irradiance.readFloats(GL_RGBA, 4);
        const auto position = maps.level.position.readFloats(GL_RG, 2);
        const BeamEdges edges(engine, maps);
        for (std::size_t i = 0; i < ours.size() / 4; ++i) {
            if (position[2 * i + 1] < 0) continue;
            ++texels;
            total += double(ours[4 * i]);
            double off = 0;
            for (std::size_t c = 4 * i; c < 4 * i + 3; ++c)
                off = std::max(off, std::abs(double(ours[c]) - double(drawn[c])) /
                                        (ofUnfocused + ofValue * double(drawn[c])));
            if (off <= 1) {
                worstOff = std::max(worstOff, off);
                continue;
            }
            ++differing;
            const int width = maps.level.frame.size.x;
            const glm::dvec2 centre(double(int(i) % width) + 0.5, double(int(i) / width) + 0.5);
            const double distance = edges.distance(centre, depthOf(maps.level, position[2 * i + 1]));
            least = std::max(least, distance);
            if (distance > 1.0 / 256) {
                ++wrong;
                printf("  texel %zu: %g, drawn %g; %g from an edge\n", i, ours[4 * i], drawn[4 * i],
                       distance);
            }
        }
    }
    printf("%s: %d of %d texels differ, none more than %.5f texels from an edge; others by %.2g of what is "
           "allowed\n",
           GetParam().name, differing, texels, least, worstOff);
    EXPECT_EQ(wrong, 0);
    EXPECT_GT(texels, 1000);
    EXPECT_GT(total, 100);
}

INSTANTIATE_TEST_SUITE_P(scenes, PlaneBeamsGLTest,
                         ::testing::Values(PlaneCase{"teapot", teapot}, PlaneCase{"shadedFloor", shadedFloor},
                                           PlaneCase{"subBoxes", subBoxes}, PlaneCase{"lamp", pointLight},
                                           PlaneCase{"reef", reef}, PlaneCase{"flanks", flanks},
                                           PlaneCase{"largeBeams", largeBeams}),
                         [](const auto& scene) { return std::string(scene.param.name); });

} // namespace
} // namespace limpid
