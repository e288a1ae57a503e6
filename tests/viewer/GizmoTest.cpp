// A handle does one thing, and what was grabbed stays under the mouse.
#include "apps/viewer/Gizmo.h"

#include <cmath>

#include <gtest/gtest.h>

#include "apps/viewer/History.h"
#include "scene/Shapes.h"

namespace limpid::viewer {
namespace {

// The search along a handle's line ends within 10⁻⁹ of the handle, which is less than a metre long here, or
// where a step changes no digit of a distance that Snell's crossing is found for to some 10⁻¹² m: a hundred
// times the first is room for both.
constexpr double found = 1e-7;
constexpr double handlePixels = 80, reach = 6;
constexpr glm::dvec2 pictureSize(640, 480);

Receiver lump(double y) {
    Receiver receiver;
    receiver.mesh = std::make_shared<const Mesh>(makeSphere(0.2, glm::vec3(0.8f)));
    receiver.translation = {0.3, y, -0.2};
    receiver.scale = {1, 2, 0.5};
    receiver.rotation = glm::angleAxis(0.7, glm::normalize(glm::dvec3(1, 2, 3)));
    return receiver;
}

constexpr glm::dvec3 meshPoint(0.05, -0.1, 0.02);

/// A receiver above or under water, seen from either side of the surface.
struct View {
    Receiver receiver;
    Projection projection;
};

std::vector<View> views() {
    std::vector<View> all;
    for (const double receiver : {0.8, -0.7})
        for (const double height : {2.0, -1.5}) {
            Camera camera;
            camera.position = {1.3, height, 1.6};
            camera.target = {0.2, receiver, -0.1};
            all.push_back({lump(receiver), Projection(camera, Water{}, pictureSize)});
        }
    return all;
}

Gizmo gizmoOf(const View& view, Gizmo::Mode mode) {
    return Gizmo(view.receiver, meshPoint, mode, view.projection, handlePixels);
}

/// A drag from a place on a handle's line to another, as a mouse does it, in some moves.
Receiver dragged(const View& view, const Gizmo& gizmo, int axis, double from, double to,
                 const glm::dvec2& aside = glm::dvec2(0), bool alike = false) {
    const auto pixel = [&](double s) { return *view.projection.pixel(gizmo.at(axis, s)); };
    GizmoDrag drag(view.receiver, gizmo, axis, pixel(from), view.projection);
    Receiver moved;
    for (int i = 1; i <= 10; ++i)
        moved = drag.to(pixel(glm::mix(from, to, i / 10.0)) + aside, view.projection, alike);
    return moved;
}

void expectMiddleStays(const View& view, const Receiver& moved) {
    EXPECT_NEAR(glm::distance(moved.toWorld(meshPoint), view.receiver.toWorld(meshPoint)), 0, 1e-12);
}

TEST(Gizmo, aHandleIsFoundWhereItIsDrawn) {
    for (const View& view : views())
        for (const auto mode : {Gizmo::Mode::Move, Gizmo::Mode::Scale}) {
            const Gizmo gizmo = gizmoOf(view, mode);
            for (int axis = 0; axis < Gizmo::axisCount; ++axis) {
                ASSERT_FALSE(gizmo.hidden[axis]);
                const auto end = view.projection.pixel(gizmo.at(axis, gizmo.size));
                ASSERT_TRUE(end);
                EXPECT_EQ(gizmo.under(*end, reach, view.projection), axis);
            }
            EXPECT_FALSE(gizmo.under(glm::dvec2(5, 5), reach, view.projection));
        }
}

TEST(Gizmo, anArrowMovesAlongItsAxisOnly) {
    for (const View& view : views()) {
        const Gizmo gizmo = gizmoOf(view, Gizmo::Mode::Move);
        for (int axis = 0; axis < Gizmo::axisCount; ++axis) {
            const double way = 0.9 * gizmo.size;
            const Receiver moved = dragged(view, gizmo, axis, 0.6 * gizmo.size, 1.5 * gizmo.size);
            const Receiver beside = dragged(view, gizmo, axis, 0.6 * gizmo.size, 1.5 * gizmo.size, {13, -7});
            EXPECT_NEAR(moved.translation[axis], view.receiver.translation[axis] + way, found);
            for (const int other : {(axis + 1) % 3, (axis + 2) % 3}) {
                EXPECT_EQ(moved.translation[other], view.receiver.translation[other]);
                EXPECT_EQ(beside.translation[other], view.receiver.translation[other]);
            }
            EXPECT_EQ(moved.rotation, view.receiver.rotation);
            EXPECT_EQ(moved.scale, view.receiver.scale);
        }
    }
}

TEST(Gizmo, aRingTurnsAboutTheMiddle) {
    for (const View& view : views()) {
        const Gizmo gizmo = gizmoOf(view, Gizmo::Mode::Turn);
        for (int axis = 0; axis < Gizmo::axisCount; ++axis) {
            // A quarter turn, whose ends are a tenth off the axes: no view here has a silhouette there.
            const Receiver moved = dragged(view, gizmo, axis, 0.1, 0.8);
            glm::dvec3 about(0);
            about[axis] = 1;
            const glm::dquat wanted = glm::angleAxis(0.7, about) * view.receiver.rotation;
            EXPECT_NEAR(std::abs(glm::dot(moved.rotation, wanted)), 1, found);
            expectMiddleStays(view, moved);
            EXPECT_EQ(moved.scale, view.receiver.scale);
        }
    }
}

TEST(Gizmo, anArmScalesAboutTheMiddle) {
    for (const View& view : views()) {
        const Gizmo gizmo = gizmoOf(view, Gizmo::Mode::Scale);
        for (int axis = 0; axis < Gizmo::axisCount; ++axis) {
            const Receiver moved = dragged(view, gizmo, axis, 0.5 * gizmo.size, gizmo.size);
            glm::dvec3 wanted = view.receiver.scale;
            wanted[axis] *= 2;
            EXPECT_NEAR(glm::distance(moved.scale, wanted), 0, 10 * found);
            EXPECT_EQ(moved.rotation, view.receiver.rotation);
            expectMiddleStays(view, moved);
            const Receiver all =
                dragged(view, gizmo, axis, 0.5 * gizmo.size, gizmo.size, glm::dvec2(0), true);
            EXPECT_NEAR(glm::distance(all.scale, 2.0 * view.receiver.scale), 0, 20 * found);
            expectMiddleStays(view, all);
            // No further than to a hundredth, and never inside out.
            const Receiver least = dragged(view, gizmo, axis, 0.5 * gizmo.size, -2 * gizmo.size);
            EXPECT_GT(least.scale[axis], 0);
        }
    }
}

TEST(Gizmo, anArrowThatPointsAtTheCameraIsHidden) {
    View view = views().front();
    Camera camera;
    camera.target = view.receiver.toWorld(meshPoint);
    camera.position = *camera.target + glm::dvec3(2, 0, 0);
    view.projection = Projection(camera, Water{}, pictureSize);
    const Gizmo gizmo = gizmoOf(view, Gizmo::Mode::Move);
    EXPECT_EQ(gizmo.hidden, glm::bvec3(true, false, false));
    EXPECT_NE(gizmo.under(0.5 * pictureSize, reach, view.projection), 0);
}

Scene sceneAt(double level) {
    Scene scene;
    scene.water.level = level;
    return scene;
}

TEST(History, goesBackAndOnStepByStep) {
    History history;
    Scene scene = sceneAt(0);
    history.begin(scene);
    EXPECT_FALSE(history.undo(scene));
    for (const double level : {0.3, 0.6, 1.0}) { // a drag is one step
        scene.water.level = level;
        history.follow(scene, level < 1);
    }
    scene.water.ior = 1.5;
    history.follow(scene, false);
    scene.camera.exposure = 2; // which is none
    history.follow(scene, false);
    EXPECT_TRUE(history.undo(scene));
    EXPECT_EQ(scene.water.level, 1);
    EXPECT_EQ(scene.water.ior, 1.333);
    EXPECT_TRUE(history.undo(scene));
    EXPECT_EQ(scene.water.level, 0);
    EXPECT_EQ(scene.camera.exposure, 2);
    EXPECT_FALSE(history.undo(scene));
    EXPECT_TRUE(history.redo(scene));
    EXPECT_EQ(scene.water.level, 1);
    scene.water.level = 5;
    history.follow(scene, false);
    EXPECT_FALSE(history.redo(scene)); // that way is left
    EXPECT_TRUE(history.undo(scene));
    EXPECT_EQ(scene.water.level, 1);
}

} // namespace
} // namespace limpid::viewer
