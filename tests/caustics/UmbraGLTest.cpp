// No light within the umbra of a sheet without thickness, however it leans, at any size of the map; and edges
// of shade that neither make nor lose light.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "core/Optics.h"
#include "engine/EngineFixture.h"

namespace limpid {
namespace {

/// A rectangle in the world: every point middle + a · u + b · w, |a| and |b| at most 1.
struct Sheet {
    glm::dvec3 middle, u, w;

    /// Whether the segment from `from` to `to` meets it.
    bool isBetween(const glm::dvec3& from, const glm::dvec3& to) const {
        const glm::dvec3 normal = glm::cross(u, w), way = to - from;
        const double along = glm::dot(normal, way);
        if (along == 0) return false;
        const double part = glm::dot(normal, middle - from) / along;
        const glm::dvec3 at = from + part * way - middle;
        return part > 0 && part < 1 && std::abs(glm::dot(at, u)) < glm::dot(u, u) &&
               std::abs(glm::dot(at, w)) < glm::dot(w, w);
    }
};

/// Directions of light below water whose surface leans by `slope` at the most: to all sides, and where it is
/// flat.
std::vector<glm::dvec3> refractedDirections(const Light& light, double slope) {
    std::vector<glm::dvec3> directions;
    for (int i = 0; i < 48; ++i)
        for (const double lean : {0.0, slope}) {
            const double angle = 2 * 3.14159265358979 * i / 48;
            const glm::dvec3 normal =
                glm::normalize(glm::dvec3(lean * std::cos(angle), 1, lean * std::sin(angle)));
            directions.push_back(
                optics::refractDirection(glm::normalize(light.direction), normal, 1 / 1.333));
        }
    return directions;
}

struct Umbra {
    int texels = 0, lit = 0;
    double most = 0; ///< W/m²
};

class UmbraGLTest : public EngineGLTest {
  protected:
    static constexpr double depth = 1.5;
    static Light sun() {
        Light light;
        light.direction = {0.4, -1, -0.35};
        return light;
    }
    /// A sheet 1 m wide whose lower edge is on the floor, `lean` degrees from upright away from the sun's
    /// side.
    static Receiver sheet(double lean) {
        const double angle = glm::radians(lean), half = 0.6;
        Receiver receiver = scenes::shape(
            "sheet", makePlane({2 * half, 1}, glm::vec3(0.8f)),
            {half * std::sin(angle), -depth + half * std::cos(angle) + (lean > 85 ? 0.3 : 0.0), 0});
        receiver.rotation = glm::angleAxis(glm::radians(90.0) - angle, glm::dvec3(0, 0, 1));
        return receiver;
    }
    static Sheet placeOf(const Receiver& r) {
        return {r.translation, r.rotation * glm::dvec3(0.6, 0, 0), r.rotation * glm::dvec3(0, 0, 0.5)};
    }
    static Scene sceneOf(double lean, Method method, int mapSize, double amplitude) {
        Scene scene;
        scene.lights = {sun()};
        scene.water.grid = {128, 128};
        if (amplitude > 0)
            scene.water.waves = {scenes::cosine(amplitude, 1.1, {1, 0.3}),
                                 scenes::cosine(0.6 * amplitude, 0.7, {-0.4, 1})};
        scene.receivers = {scenes::floorAt(-depth, 5), sheet(lean)};
        scene.caustics.mapSize = mapSize;
        scene.caustics.method = method;
        return scene;
    }
    static double slopeOf(const Scene& scene) {
        double slope = 0;
        for (const Wave& wave : scene.water.waves)
            slope += 2 * 3.14159265358979 * wave.amplitude / wave.wavelength;
        return slope;
    }
    /// Texels of the floor that no direction of light comes to, from a texel's every corner.
    static Umbra umbraOf(const Scene& scene, const MapData& map, double texel) {
        const auto directions = refractedDirections(scene.lights[0], slopeOf(scene));
        const Sheet sheet = placeOf(scene.receivers[1]);
        Umbra umbra;
        for (std::size_t i = 0; i < map.irradiance.size() / 3; ++i) {
            const float* p = &map.position[4 * i];
            if (p[3] == 0) continue;
            bool dark = true;
            for (int corner = 0; corner < 4 && dark; ++corner) {
                const glm::dvec3 at(p[0] + (corner & 1 ? texel : -texel), p[1] + 1e-6,
                                    p[2] + (corner & 2 ? texel : -texel));
                for (const glm::dvec3& d : directions)
                    dark = dark && sheet.isBetween(at, at - 2 * depth / -d.y * d);
            }
            if (!dark) continue;
            ++umbra.texels;
            umbra.lit += map.irradiance[3 * i] > 0;
            umbra.most = std::max<double>(umbra.most, map.irradiance[3 * i]);
        }
        return umbra;
    }
    static void expectDark(double lean, Method method, int mapSize, double amplitude) {
        SCOPED_TRACE(fmt::format("{}, {} degrees from upright, map {}, amplitude {} m", methodName(method),
                                 lean, mapSize, amplitude));
        const Scene scene = sceneOf(lean, method, mapSize, amplitude);
        Engine& engine = sharedEngine();
        const Baked baked = bake(engine, scene);
        const double texel = baked.frames.at(0).texel;
        const Umbra umbra = umbraOf(scene, baked.maps.at(0), 0.75 * texel);
        EXPECT_GT(umbra.texels, 0);
        EXPECT_EQ(umbra.lit, 0) << "of " << umbra.texels << " texels, up to " << umbra.most << " W/m²";
    }
};

TEST_F(UmbraGLTest, isDarkHoweverASheetLeans) {
    for (const Method method : {Method::ExactBeam, Method::PhotonSplat})
        for (const double lean : {0.0, 5.0, 20.0, 45.0, 80.0, 90.0})
            for (const double amplitude : {0.0, 0.012})
                expectDark(lean, method, 256, amplitude);
}

TEST_F(UmbraGLTest, isDarkAtAnySizeOfTheMap) {
    for (const Method method : {Method::ExactBeam, Method::PhotonSplat})
        for (const int size : {64, 1024})
            expectDark(0, method, size, 0.012);
}

/// A pane of half the floor's sides half-way down, flat water, light straight down; the map's texels end at
/// the pane's edges.
Scene paneOver(double side, int mapSize) {
    Scene scene;
    scene.water.level = side / 2;
    scene.water.grid = {256, 256};
    scene.lights = {scenes::sunAt(0)};
    scene.receivers = {
        scenes::floorAt(0, side),
        scenes::shape("pane", makePlane(glm::dvec2(side / 2), glm::vec3(0.8f)), {0, side / 4, 0})};
    scene.caustics.mapSize = mapSize;
    return scene;
}

TEST_F(UmbraGLTest, edgesNeitherMakeNorLoseLight) {
    const double perSquareMetre = 1 - std::pow(0.333 / 2.333, 2);
    for (const double side : {2.0, 20.0})
        for (const int size : {64, 128, 256, 1024}) {
            SCOPED_TRACE(fmt::format("{} m, map {}", side, size));
            const Baked baked = bake(paneOver(side, size));
            const MapData& floor = baked.maps.at(0);
            double most = 0;
            for (std::size_t i = 0; i < floor.irradiance.size() / 3; ++i)
                if (std::max(std::abs(floor.position[4 * i]), std::abs(floor.position[4 * i + 2])) <
                    0.25 * side)
                    most = std::max<double>(most, floor.irradiance[3 * i]);
            EXPECT_EQ(most, 0);
            EXPECT_NEAR(floor.deposited / (0.75 * side * side * perSquareMetre), 1, 2e-4);
        }
}

TEST_F(UmbraGLTest, holdsWhatHangsStraightBelow) {
    for (const Method method : {Method::ExactBeam, Method::PhotonSplat})
        for (const int size : {64, 256, 1024}) {
            Scene scene = paneOver(2, size);
            scene.caustics.method = method;
            scene.caustics.photonGrid = {100, 100};
            scene.receivers.push_back(
                scenes::shape("below", makePlane(glm::dvec2(1), glm::vec3(0.8f)), {0, 0.25, 0}));
            scene.receivers.push_back(
                scenes::shape("ball", makeSphere(0.1, glm::vec3(0.8f)), {0.2, 0.35, 0.1}));
            const Baked baked = bake(scene);
            for (const std::size_t map : {2, 3})
                EXPECT_EQ(*std::max_element(baked.maps.at(map).irradiance.begin(),
                                            baked.maps.at(map).irradiance.end()),
                          0)
                    << scene.receivers[map].name << ", map " << size;
        }
}

} // namespace
} // namespace limpid
