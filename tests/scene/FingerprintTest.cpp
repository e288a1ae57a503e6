#include "scene/Fingerprint.h"

#include <functional>
#include <set>

#include <gtest/gtest.h>

#include "scene/Shapes.h"

namespace limpid {
namespace {

Scene floorScene() {
    Scene scene;
    scene.lights.emplace_back();
    scene.water.waves.emplace_back();
    Receiver& floor = scene.receivers.emplace_back();
    floor.mesh = std::make_shared<const Mesh>(makePlane(glm::dvec2(2), glm::vec3(0.8f)));
    return scene;
}

TEST(LightFingerprint, changesWithWhateverLightDependsOn) {
    const std::function<void(Scene&)> changes[] = {
        [](Scene&) {},
        [](Scene& s) { s.water.level += 0.1; },
        [](Scene& s) { s.water.absorption.z = 0.1; },
        [](Scene& s) { s.water.waves[0].phase = 1; },
        [](Scene& s) { s.water.waves.emplace_back(); },
        [](Scene& s) { s.lights[0].direction.x = 0.1; },
        [](Scene& s) { s.lights.emplace_back(); },
        [](Scene& s) { s.lights[0].type = LightType::Point; },
        [](Scene& s) { s.lights[0].type = LightType::Point, s.lights[0].outerCone = 30; },
        [](Scene& s) {
            s.lights[0].type = LightType::Point, s.lights[0].outerCone = 30, s.lights[0].innerCone = 10;
        },
        [](Scene& s) { s.receivers[0].translation.y = -1; },
        [](Scene& s) { s.receivers[0].rotation.x = 0.1; },
        [](Scene& s) {
            s.receivers[0].mesh = std::make_shared<const Mesh>(makePlane(glm::dvec2(3), glm::vec3(0.8f)));
        },
        [](Scene& s) {
            Mesh mesh = *s.receivers[0].mesh;
            mesh.materials[0].alphaMode = AlphaMode::Mask;
            s.receivers[0].mesh = std::make_shared<const Mesh>(mesh);
        },
        [](Scene& s) {
            Mesh mesh = *s.receivers[0].mesh;
            mesh.materials[0].transmission = 0.5f;
            s.receivers[0].mesh = std::make_shared<const Mesh>(mesh);
        },
        [](Scene& s) {
            Mesh mesh = *s.receivers[0].mesh;
            mesh.materials[0].transmission = 0.5f;
            mesh.materials[0].baseColor.x = 0.5f;
            s.receivers[0].mesh = std::make_shared<const Mesh>(mesh);
        },
    };
    std::set<std::uint64_t> prints;
    for (const auto& change : changes) {
        Scene scene = floorScene();
        change(scene);
        EXPECT_TRUE(prints.insert(lightFingerprint(scene)).second) << prints.size();
    }
}

TEST(LightFingerprint, doesNotCareForTheMethodOrTheCamera) {
    Scene scene = floorScene();
    const std::uint64_t before = lightFingerprint(scene);
    scene.caustics.planes = 3;
    scene.camera.exposure = 2;
    scene.water.grid = {8, 8};
    EXPECT_EQ(lightFingerprint(scene), before);
}

TEST(LooksFingerprint, changesWithWhateverSurfacesLookLike) {
    const std::function<void(Mesh&)> changes[] = {
        [](Mesh&) {},
        [](Mesh& m) { m.materials[0].baseColor.y = 0.1f; },
        [](Mesh& m) { m.materials[0].emission.z = 1; },
        [](Mesh& m) { m.materials[0].normalScale = 0.5f; },
        [](Mesh& m) { m.normals[0].x = 0.1f; },
        [](Mesh& m) { m.uvs[0].x += 1; },
        [](Mesh& m) { m.colors.resize(m.positions.size()); },
        [](Mesh& m) {
            m.images = {Image{1, 1, {1, 2, 3, 4}}};
        },
        [](Mesh& m) {
            m.images = {Image{1, 1, {1, 2, 3, 5}}};
        },
    };
    std::set<std::uint64_t> prints;
    for (const auto& change : changes) {
        Scene scene = floorScene();
        Mesh mesh = *scene.receivers[0].mesh;
        change(mesh);
        scene.receivers[0].mesh = std::make_shared<const Mesh>(mesh);
        EXPECT_TRUE(prints.insert(looksFingerprint(scene)).second) << prints.size();
    }
}

} // namespace
} // namespace limpid
