#include "Pool.h"

#include <cmath>
#include <cstddef>

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "Shaders.h"

namespace {

enum Uniform { ViewProjection, Translation, Albedo, Eye, MapCount, WorldToTexture = 8 };
constexpr std::size_t mostMaps = 5;
constexpr float depth = 1.2f; // m
const glm::vec3 eye(0.4f, -0.25f, 1.75f), target(0, -0.95f, 0);
constexpr float fov = 50; // degrees

/// A (2, 3) torus knot's middle line.
glm::vec3 knotAt(float turn) {
    const float around = 2 * turn, radius = 0.3f + 0.13f * std::cos(3 * turn);
    return {radius * std::cos(around), 0.13f * std::sin(3 * turn), radius * std::sin(around)};
}

} // namespace

Pool::Object Pool::makeFloor() {
    const glm::vec3 up(0, 1, 0);
    return {"floor",
            {0, -depth, 0},
            {0.75f, 0.8f, 0.8f},
            false,
            {{{-2, 0, -2}, up}, {{-2, 0, 2}, up}, {{2, 0, -2}, up}, {{2, 0, 2}, up}},
            {0, 1, 2, 2, 1, 3}};
}

Pool::Object Pool::makeKnot() {
    constexpr int along = 384, around = 32;
    constexpr float tube = 0.065f; // m
    Object knot{"knot", {0, -0.9f, 0}, {0.85f, 0.5f, 0.3f}, true, {}, {}};
    for (int i = 0; i < along; ++i) {
        const float turn = glm::two_pi<float>() * float(i) / along;
        const glm::vec3 middle = knotAt(turn), ahead = glm::normalize(knotAt(turn + 0.01f) - middle);
        const glm::vec3 side = glm::normalize(glm::cross(ahead, glm::vec3(0, 1, 0)));
        const glm::vec3 up = glm::cross(side, ahead);
        for (int j = 0; j < around; ++j) {
            const float angle = glm::two_pi<float>() * float(j) / around;
            const glm::vec3 normal = std::cos(angle) * side + std::sin(angle) * up;
            knot.vertices.push_back({middle + tube * normal, normal});
            const auto a = GLuint(i * around + j), b = GLuint(i * around + (j + 1) % around);
            const auto c = GLuint((i + 1) % along * around + j),
                       d = GLuint((i + 1) % along * around + (j + 1) % around);
            knot.indices.insert(knot.indices.end(), {a, c, b, b, c, d});
        }
    }
    return knot;
}

Pool::Pool() : _objects{makeFloor(), makeKnot()}, _program(makeProgram({"pool.vert", "pool.frag"})) {
    for (Object& object : _objects)
        upload(object);
}

Pool::~Pool() {
    for (Object& object : _objects) {
        glDeleteVertexArrays(1, &object.vertexArray);
        glDeleteBuffers(1, &object.vertexBuffer);
        glDeleteBuffers(1, &object.indexBuffer);
    }
    glDeleteProgram(_program);
}

void Pool::upload(Object& object) const {
    glCreateBuffers(1, &object.vertexBuffer);
    glNamedBufferStorage(object.vertexBuffer, GLsizeiptr(object.vertices.size() * sizeof(Vertex)),
                         object.vertices.data(), 0);
    glCreateBuffers(1, &object.indexBuffer);
    glNamedBufferStorage(object.indexBuffer, GLsizeiptr(object.indices.size() * sizeof(GLuint)),
                         object.indices.data(), 0);
    glCreateVertexArrays(1, &object.vertexArray);
    glVertexArrayVertexBuffer(object.vertexArray, 0, object.vertexBuffer, 0, sizeof(Vertex));
    glVertexArrayElementBuffer(object.vertexArray, object.indexBuffer);
    for (const GLuint attribute : {0u, 1u}) {
        glEnableVertexArrayAttrib(object.vertexArray, attribute);
        glVertexArrayAttribFormat(object.vertexArray, attribute, 3, GL_FLOAT, GL_FALSE,
                                  attribute * GLuint(sizeof(glm::vec3)));
        glVertexArrayAttribBinding(object.vertexArray, attribute, 0);
    }
}

limpid::Receiver Pool::receiverOf(const Object& object) {
    limpid::HostMesh mesh;
    mesh.vertexBuffer = object.vertexBuffer;
    mesh.vertexStride = sizeof(Vertex);
    mesh.normalOffset = offsetof(Vertex, normal);
    mesh.vertexCount = int(object.vertices.size());
    mesh.indexBuffer = object.indexBuffer;
    mesh.indexCount = int(object.indices.size());
    for (const Vertex& vertex : object.vertices)
        mesh.bounds.add(glm::dvec3(vertex.position));
    mesh.closed = object.closed;
    mesh.albedo = object.albedo;
    limpid::Receiver receiver = limpid::receiverOf(object.name, mesh);
    receiver.translation = object.translation;
    return receiver;
}

limpid::Scene Pool::scene(const limpid::Wave& waves) const {
    limpid::Scene scene;
    limpid::Light sun;
    sun.name = "sun";
    sun.direction = {0.35, -1, -0.2};
    sun.irradiance = glm::dvec3(4);
    scene.lights = {sun};
    scene.water.waves = {waves};
    for (const Object& object : _objects)
        scene.receivers.push_back(receiverOf(object));
    scene.camera.position = eye;
    scene.camera.target = target;
    scene.camera.verticalFov = fov;
    return scene;
}

void Pool::draw(std::span<const limpid::LitMap> maps, glm::ivec2 size) const {
    glViewport(0, 0, size.x, size.y);
    glClearColor(0.05f, 0.15f, 0.2f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glUseProgram(_program);
    const glm::mat4 viewProjection =
        glm::perspective(glm::radians(fov), float(size.x) / float(size.y), 0.05f, 20.0f) *
        glm::lookAt(eye, target, glm::vec3(0, 1, 0));
    glUniformMatrix4fv(ViewProjection, 1, GL_FALSE, &viewProjection[0].x);
    glUniform3fv(Eye, 1, &eye.x);
    for (std::size_t i = 0; i < _objects.size(); ++i) {
        const Object& object = _objects[i];
        GLuint count = 0;
        for (const limpid::LitMap& map : maps) {
            if (map.receiver != int(i) || count == mostMaps) continue;
            glUniformMatrix4fv(WorldToTexture + GLint(count), 1, GL_FALSE, &map.worldToTexture[0].x);
            glBindTextureUnit(count, map.irradiance);
            glBindTextureUnit(count + mostMaps, map.position);
            glBindTextureUnit(count + 2 * mostMaps, map.normal);
            ++count;
        }
        glUniform1i(MapCount, GLint(count));
        glUniform3fv(Translation, 1, &object.translation.x);
        glUniform3fv(Albedo, 1, &object.albedo.x);
        glBindVertexArray(object.vertexArray);
        glDrawElements(GL_TRIANGLES, GLsizei(object.indices.size()), GL_UNSIGNED_INT, nullptr);
    }
}
