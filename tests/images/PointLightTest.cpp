// Point lights under water: they light what is there directly, and what is there shades it.
#include <cmath>

#include "core/Optics.h"
#include "images/PictureFixture.h"

namespace limpid {
namespace {

constexpr double pi = 3.14159265358979;
const glm::ivec2 size(120, 80);

class PointLightTest : public PictureFixture {
  protected:
    /// A floor 2 m down and a point light 1 m above it, in black water, seen by a camera in it.
    static Scene pointLightOverFloor() {
        Scene scene;
        scene.receivers = {scenes::floorAt(-2, 8)};
        Light pointLight;
        pointLight.type = LightType::Point;
        pointLight.position = {0.2, -1, -0.1};
        pointLight.intensity = {3, 2, 1};
        scene.lights = {pointLight};
        scene.ambientRadiance = scene.skyRadiance = glm::dvec3(0);
        scene.water.absorption = {0.4, 0.2, 0.1};
        scene.water.grid = {8, 8};
        scene.caustics.mapSize = 64;
        scene.camera.position = {0, -0.6, 1.5};
        scene.camera.target = {0, -2, 0};
        return scene;
    }
    /// Where the ray through a pixel meets the floor.
    static glm::dvec3 floorPoint(const Scene& scene, glm::ivec2 pixel) {
        const glm::dvec3 view = rayThrough(scene.camera, pixel, size);
        return *scene.camera.position + view * ((-2 - scene.camera.position->y) / view.y);
    }
    /// albedo / π · I cosθ / r² e^{-K r}, and again through the water to the camera.
    static glm::dvec3 radianceOf(const Scene& scene, const glm::dvec3& point) {
        const Light& pointLight = scene.lights[0];
        const glm::dvec3 way = point - pointLight.position;
        const double r = glm::length(way);
        const double seen = glm::distance(point, *scene.camera.position);
        const double share = pointLight.isSpot()
                                 ? optics::coneShare(glm::dot(way / r, pointLight.direction),
                                                     std::cos(glm::radians(pointLight.innerCone)),
                                                     std::cos(glm::radians(pointLight.outerCone)))
                                 : 1;
        return 0.8 / pi * pointLight.intensity * share * (-way.y / r) / (r * r) *
               optics::extinction(scene.water.absorption, r + seen);
    }
};

TEST_F(PointLightTest, theFloorHasItsIrradianceByTheInverseSquareAndTheWater) {
    const Scene scene = pointLightOverFloor();
    const Picture picture = render(scene, size);
    for (int y = 2; y < size.y; y += 11)
        for (int x = 2; x < size.x; x += 13) {
            const glm::dvec3 expected = radianceOf(scene, floorPoint(scene, {x, y}));
            // Four samples stand for the pixel's middle: its curvature over a hundredth of a metre is 1e-3.
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(at(picture, x, y)[c], expected[c], 2e-3 * expected[c]) << x << ' ' << y;
        }
}

TEST_F(PointLightTest, aSpotUnderWaterHasItsCone) {
    Scene scene = pointLightOverFloor();
    scene.lights[0].direction = {0, -1, 0};
    scene.lights[0].innerCone = 10;
    scene.lights[0].outerCone = 40;
    const Picture picture = render(scene, size);
    int dark = 0;
    for (int y = 2; y < size.y; y += 5)
        for (int x = 2; x < size.x; x += 5) {
            const glm::dvec3 expected = radianceOf(scene, floorPoint(scene, {x, y}));
            // A pixel is 2 cm wide; within it the cone's share changes by a hundredth of its brightest at
            // most.
            EXPECT_NEAR(at(picture, x, y).x, expected.x, 0.01 * radianceOf(scene, {0.2, -2, -0.1}).x)
                << x << ' ' << y;
            dark += expected.x == 0;
        }
    EXPECT_GT(dark, 50);
}

TEST_F(PointLightTest, aSphereShadesTheFloorWithinItsCone) {
    Scene scene = pointLightOverFloor();
    const glm::dvec3 center(0.35, -1.5, -0.2);
    const double radius = 0.15;
    scene.receivers.push_back(scenes::shape("ball", makeSphere(radius, glm::vec3(0.8f)), center));
    const Picture picture = render(scene, size);
    const glm::dvec3 toBall = center - scene.lights[0].position;
    const double distance = glm::length(toBall), half = std::asin(radius / distance);
    int dark = 0, lit = 0;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const glm::dvec3 point = floorPoint(scene, {x, y});
            const glm::dvec3 view = glm::normalize(point - *scene.camera.position);
            const glm::dvec3 ball = center - *scene.camera.position;
            if (glm::length(glm::cross(view, ball)) < 1.2 * radius) continue; // the ball itself
            const glm::dvec3 way = glm::normalize(point - scene.lights[0].position);
            const double angle = std::acos(glm::dot(way, toBall) / distance);
            // The mesh's silhouette lies inside of the sphere by 1/2 (2π/32/2)², 0.5 %; a pixel of 2 cm is
            // 1° from 1.2 m, and a texel 0.1°.
            if (std::abs(angle - half) < glm::radians(1.2)) continue;
            const double share = at(picture, x, y).x / radianceOf(scene, point).x;
            EXPECT_NEAR(share, angle < half ? 0 : 1, 2e-3) << x << ' ' << y;
            ++(angle < half ? dark : lit);
        }
    EXPECT_GT(dark, 50);
    EXPECT_GT(lit, 5000);
}

TEST_F(PointLightTest, aBakeDrawsNoPointLightShadow) {
    Engine engine(context());
    bake(engine, pointLightOverFloor());
    EXPECT_EQ(context().ledger().bytes("lamp shadow map"), 0);
    engine.render(0, {16, 12});
    EXPECT_GT(context().ledger().bytes("lamp shadow map"), 0);
}

} // namespace
} // namespace limpid
