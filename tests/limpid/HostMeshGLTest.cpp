// Triangles in buffers of the host's: the light and the shade that the same triangles have from memory.
#include <cmath>

#include <gmock/gmock.h>

#include "engine/Scenes.h"
#include "limpid/Caustics.h"
#include "limpid/HostData.h"

namespace limpid {
namespace {

using namespace test;

Scene sceneOf(Method method) {
    Scene scene = scenes::floorPastSphere(30);
    scene.water.waves = {scenes::cosine(0.01, 0.5, {1, 0.3})};
    scene.water.center = glm::dvec2(0);
    scene.water.size = glm::dvec2(2.4);
    scene.caustics.mapSize = 128;
    scene.caustics.method = method;
    scene.receivers[1].rotation = glm::normalize(glm::dquat(0.9, 0.3, 0.1, -0.2));
    scene.receivers[1].scale = {0.9, 1.2, 1};
    return scene;
}

/// Whose second receiver is the host's.
Scene withHost(Scene scene, const HostMesh& mesh) {
    Receiver& own = scene.receivers[1];
    Receiver host = receiverOf(own.name, mesh);
    host.translation = own.translation;
    host.rotation = own.rotation;
    host.scale = own.scale;
    own = host;
    return scene;
}

std::vector<std::vector<float>> mapsOf(Caustics& caustics, const Scene& scene) {
    caustics.set(scene);
    caustics.update(0);
    std::vector<std::vector<float>> maps;
    for (int i = 0; i < int(caustics.maps().size()); ++i)
        maps.push_back(caustics.irradiance(i));
    return maps;
}

TEST(HostMeshGLTest, isLitAndShadesAsTheSameMeshInMemory) {
    for (const Method method : {Method::ExactBeam, Method::LevelMap})
        for (const int indexBytes : {2, 4}) {
            SCOPED_TRACE(std::string(methodName(method)));
            SCOPED_TRACE(indexBytes);
            Caustics caustics(Context::headless());
            const Scene scene = sceneOf(method);
            const auto expected = mapsOf(caustics, scene);
            HostBuffers buffers(*scene.receivers[1].mesh, indexBytes);
            buffers.mesh().closed = true;
            buffers.mesh().hull = scene.receivers[1].mesh; // so that the maps have the same boxes
            const auto maps = mapsOf(caustics, withHost(scene, buffers.mesh()));
            ASSERT_EQ(maps.size(), expected.size());
            for (std::size_t i = 0; i < maps.size(); ++i)
                EXPECT_LT(meanDifference(maps[i], expected[i]), 1e-3) << i; // positions round otherwise
        }
}

TEST(HostMeshGLTest, inItsBoundsAloneItShadesTheSame) {
    Caustics caustics(Context::headless());
    for (const bool walls : {false, true}) {
        SCOPED_TRACE(walls);
        const Scene scene = sceneOf(Method::ExactBeam);
        const auto expected = mapsOf(caustics, scene);
        HostBuffers buffers(*scene.receivers[1].mesh, 4);
        buffers.mesh().closed = true;
        buffers.mesh().walls = walls;
        const auto maps = mapsOf(caustics, withHost(scene, buffers.mesh()));
        EXPECT_LT(meanDifference(maps[0], expected[0]), 1e-3); // the floor
        const std::vector<LitMap> lit = caustics.maps();
        EXPECT_EQ(lit.size(), walls ? 6u : 2u);
        const float most = *std::max_element(maps[1].begin(), maps[1].end());
        EXPECT_GT(most, 0.5f);
    }
}

TEST(HostMeshGLTest, needsNoIndices) {
    Caustics caustics(Context::headless());
    const Scene scene = sceneOf(Method::ExactBeam);
    Mesh corners = *scene.receivers[1].mesh;
    corners.positions.clear(), corners.normals.clear();
    for (const std::uint32_t i : scene.receivers[1].mesh->indices) {
        corners.positions.push_back(scene.receivers[1].mesh->positions[i]);
        corners.normals.push_back(scene.receivers[1].mesh->normals[i]);
    }
    HostBuffers indexed(*scene.receivers[1].mesh, 4), plain(corners, 4);
    plain.mesh().indexBuffer = 0;
    plain.mesh().indexCount = 0;
    EXPECT_EQ(mapsOf(caustics, withHost(scene, plain.mesh())),
              mapsOf(caustics, withHost(scene, indexed.mesh())));
}

TEST(HostMeshGLTest, isDrawnInPictures) {
    Caustics caustics(Context::headless());
    const Scene scene = sceneOf(Method::ExactBeam);
    caustics.set(scene);
    const Picture expected = caustics.render(0, {96, 64});
    HostBuffers buffers(*scene.receivers[1].mesh, 4);
    buffers.mesh().closed = true;
    buffers.mesh().hull = scene.receivers[1].mesh;
    Scene host = withHost(scene, buffers.mesh());
    caustics.set(host);
    EXPECT_LT(meanDifference(caustics.render(0, {96, 64}).rgb, expected.rgb), 2e-3);
}

TEST(HostMeshGLTest, saysWhatItExpects) {
    Caustics caustics(Context::headless());
    const Scene scene = sceneOf(Method::ExactBeam);
    HostBuffers buffers(*scene.receivers[1].mesh, 4);
    const auto refuses = [&](const std::string& expected, const auto& spoil) {
        HostMesh mesh = buffers.mesh();
        spoil(mesh);
        EXPECT_THAT(errorOf([&] { caustics.set(withHost(scene, mesh)); }), ::testing::HasSubstr(expected));
    };
    refuses("HostMesh::vertexBuffer: expected an OpenGL buffer, got 0",
            [](HostMesh& m) { m.vertexBuffer = 0; });
    refuses("HostMesh::vertexStride: expected a multiple of 4, at least 12, got 30",
            [](HostMesh& m) { m.vertexStride = 30; });
    refuses("HostMesh::positionOffset: expected at most 16 in a vertex of 28 bytes, got 20",
            [](HostMesh& m) { m.positionOffset = 20; });
    refuses("HostMesh::indexCount: expected a multiple of 3, at least 3, got 4",
            [](HostMesh& m) { m.indexCount = 4; });
    refuses("HostMesh::bounds: expected finite numbers, min <= max", [](HostMesh& m) { m.bounds = {}; });
    refuses("receivers[1]: HostMesh.vertexBuffer: expected at least",
            [](HostMesh& m) { m.vertexCount += 1; });
    refuses("receivers[1]: HostMesh.indexBuffer: expected an OpenGL buffer, got 4711, which names none",
            [](HostMesh& m) { m.indexBuffer = 4711; });
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

} // namespace
} // namespace limpid
