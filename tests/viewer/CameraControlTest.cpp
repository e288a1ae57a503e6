// What mouse and keys do to a camera, and where it then shows things.
#include "apps/viewer/CameraControl.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "apps/viewer/Ladder.h"
#include "apps/viewer/Pick.h"
#include "apps/viewer/Projection.h"
#include "scene/Shapes.h"

namespace limpid::viewer {
namespace {

// Double precision: a few roundings of numbers of size 1.
constexpr double exact = 1e-12;

Camera level() {
    Camera camera;
    camera.position = {0, 1, 4};
    camera.target = {0, 1, 0};
    return camera;
}

Water waterAt(double level) {
    Water water;
    water.level = level;
    return water;
}

Scene ball(const glm::dvec3& at) {
    Scene scene;
    Receiver receiver;
    receiver.mesh = std::make_shared<const Mesh>(makeSphere(0.2, glm::vec3(0.8f)));
    receiver.translation = at;
    receiver.scale = {1, 2, 1};
    receiver.rotation = glm::angleAxis(0.7, glm::normalize(glm::dvec3(1, 2, 3)));
    scene.receivers = {receiver};
    return scene;
}

void expectNear(const glm::dvec3& a, const glm::dvec3& b, double tolerance = exact) {
    EXPECT_NEAR(glm::distance(a, b), 0, tolerance) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(CameraControl, orbitGoesAroundTheTarget) {
    Camera camera = level();
    orbit(camera, {std::numbers::pi / 2, 0});
    expectNear(*camera.position, {-4, 1, 0}); // the scene turned right: the camera went left
    expectNear(*camera.target, {0, 1, 0});
    orbit(camera, {-std::numbers::pi / 2, glm::radians(30.0)});
    expectNear(*camera.position, {0, 1 + 4 * 0.5, 4 * std::sqrt(0.75)});
}

TEST(CameraControl, orbitStaysOffThePoles) {
    Camera camera = level();
    orbit(camera, {0, 3});
    EXPECT_NEAR(std::asin((camera.position->y - 1) / 4), glm::radians(89.0), exact);
    orbit(camera, {0, -6});
    EXPECT_NEAR(std::asin((camera.position->y - 1) / 4), glm::radians(-89.0), exact);
}

TEST(CameraControl, panCarriesTheTargetWithTheMouse) {
    Camera camera = level();
    const glm::dvec3 target = *camera.target;
    const glm::dvec2 size(400, 200);
    pan(camera, {0.1, -0.2});
    const auto shown = Projection(camera, waterAt(-10), size).pixel(target);
    ASSERT_TRUE(shown);
    EXPECT_NEAR(shown->x, 200 + 0.1 * 200, 1e-9);
    EXPECT_NEAR(shown->y, 100 - 0.2 * 200, 1e-9);
}

TEST(CameraControl, zoomAndFlyKeepTheirWay) {
    Camera camera = level();
    zoom(camera, 0.5);
    expectNear(*camera.position, {0, 1, 2});
    fly(camera, {0.5, 0.25, 1});
    expectNear(*camera.position, {1, 1.5, 0});
    expectNear(*camera.target, {1, 1.5, -2});
    zoom(camera, 1e-12);
    EXPECT_GT(glm::distance(*camera.position, *camera.target), 9e-5);
}

TEST(CameraControl, frameShowsAllOfTheBounds) {
    for (const double waterLevel : {-10.0, 2.0}) {
        Camera camera = level();
        camera.position = {3, 6, 4};
        const Water water = waterAt(waterLevel);
        Bounds bounds;
        bounds.add({0.5, 0.1, 0.2});
        bounds.add({1.5, 0.9, 0.7});
        frame(camera, bounds, water);
        const Projection projection(camera, water, {300, 200});
        const auto middle = projection.pixel(bounds.center());
        ASSERT_TRUE(middle);
        EXPECT_NEAR(glm::distance(*middle, glm::dvec2(150, 100)), 0, 1e-6);
        for (int i = 0; i < 8; ++i) {
            const auto corner = projection.pixel({i & 1 ? 1.5 : 0.5, i & 2 ? 0.9 : 0.1, i & 4 ? 0.7 : 0.2});
            ASSERT_TRUE(corner);
            EXPECT_TRUE(corner->x > 0 && corner->x < 300 && corner->y > 0 && corner->y < 200);
        }
    }
}

TEST(Projection, raysGoBackThroughTheirPixels) {
    Camera camera = level();
    camera.position = {1, 2, 3};
    camera.target = {0.2, 0.1, -0.3};
    const Projection projection(camera, waterAt(-10), {640, 480});
    for (const glm::dvec2 pixel : {glm::dvec2(320, 240), glm::dvec2(10, 470), glm::dvec2(630, 3)}) {
        const Ray ray = projection.ray(pixel);
        const auto back = projection.pixel(ray.origin + 2.5 * ray.direction);
        ASSERT_TRUE(back);
        EXPECT_NEAR(glm::distance(*back, pixel), 0, 1e-9);
        EXPECT_FALSE(projection.pixel(ray.origin - ray.direction));
    }
}

TEST(Projection, whatIsUnderWaterIsSeenWhereSnellPutsIt) {
    Camera camera = level();
    camera.position = {0, 1, 0};
    camera.target = {1, 0, 0};
    const Water water;
    const glm::dvec3 point(2, -1.5, 0);
    const glm::dvec3 seen = Projection(camera, water, {100, 100}).seenAt(point);
    EXPECT_EQ(seen.y, 0);
    const double above = std::atan2(seen.x, 1), below = std::atan2(2 - seen.x, 1.5);
    // flatCrossing stops after ten steps of Newton's, which double the digits each.
    EXPECT_NEAR(std::sin(above), 1.333 * std::sin(below), 1e-9);
    expectNear(Projection(camera, water, {100, 100}).seenAt({0.5, 0.2, 0.1}), {0.5, 0.2, 0.1});
}

TEST(Pick, findsWhatThePictureShowsThroughTheWater) {
    for (const double y : {0.8, -0.7}) {
        const Scene scene = ball({0.3, y, -0.2});
        Camera camera = level();
        camera.position = {1, 2, 3};
        const Projection projection(camera, scene.water, {640, 480});
        const auto pixel = projection.pixel(scene.receivers[0].translation);
        ASSERT_TRUE(pixel);
        const auto hit = pick(scene, projection.ray(*pixel));
        ASSERT_TRUE(hit);
        EXPECT_EQ(hit->receiver, 0);
        // The ray aims at the middle, and the ball is at most 0.4 m to its end.
        EXPECT_LT(glm::distance(hit->point, scene.receivers[0].translation), 0.4);
        EXPECT_FALSE(pick(scene, projection.ray(*pixel + glm::dvec2(200, 0))));
    }
}

TEST(Pick, takesTheNearest) {
    Scene scene = ball({0, 1, 0});
    scene.receivers.push_back(ball({0, 1, 1}).receivers[0]);
    scene.water.level = -5;
    const auto hit = pick(scene, Projection(level(), scene.water, {100, 100}).ray({50, 50}));
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->receiver, 1);
}

TEST(Ladder, findsTheFinestStepThatKeepsUp) {
    Ladder ladder({1, 0.25, 0.0625});
    EXPECT_EQ(ladder.step(), 2u);
    ladder.measured(2, 1, 50); // a quarter is expected to take 4 ms, the whole 16
    EXPECT_EQ(ladder.step(), 0u);
    ladder.measured(0, 120, 50);
    EXPECT_EQ(ladder.step(), 1u); // 30 ms expected
    ladder.measured(1, 30, 50);
    EXPECT_EQ(ladder.step(), 1u); // all of it would take 120
    ladder.measured(1, 60, 50);
    EXPECT_EQ(ladder.step(), 2u);
    ladder.measured(2, 500, 50);
    EXPECT_EQ(ladder.step(), 2u); // there is no coarser one
}

TEST(Ladder, doesNotSwingBetweenTwoSteps) {
    // Half of the time does not shrink with the work, which makes every expectation wrong.
    Ladder ladder({1, 0.5, 0.25, 0.125});
    const auto cost = [](std::size_t step) { return 30 + 60 / std::pow(2.0, double(step)); };
    std::vector<std::size_t> steps;
    for (int i = 0; i < 12; ++i) {
        ladder.measured(ladder.step(), cost(ladder.step()), 50);
        steps.push_back(ladder.step());
    }
    for (std::size_t i = 4; i < steps.size(); ++i)
        EXPECT_EQ(steps[i], steps[3]);
}

} // namespace
} // namespace limpid::viewer
