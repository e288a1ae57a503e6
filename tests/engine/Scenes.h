#pragma once
#include <cmath>
#include <filesystem>
#include <memory>

#include "Folders.h"
#include "io/gltf/Gltf.h"
#include "scene/Scene.h"
#include "scene/Shapes.h"

/// Small scenes that several tests use.
namespace limpid::scenes {

inline Receiver shape(const char* name, Mesh mesh, const glm::dvec3& translation) {
    Receiver receiver;
    receiver.name = name;
    receiver.mesh = std::make_shared<const Mesh>(std::move(mesh));
    receiver.translation = translation;
    return receiver;
}

/// Moves `other` by `at` and makes it part of `mesh`, with its materials.
inline void join(Mesh& mesh, const Mesh& other, const glm::dvec3& at) {
    const auto first = std::uint32_t(mesh.positions.size()), firstIndex = std::uint32_t(mesh.indices.size());
    for (const glm::dvec3& p : other.positions)
        mesh.positions.push_back(p + at);
    mesh.normals.insert(mesh.normals.end(), other.normals.begin(), other.normals.end());
    mesh.uvs.insert(mesh.uvs.end(), other.uvs.begin(), other.uvs.end());
    for (const std::uint32_t i : other.indices)
        mesh.indices.push_back(first + i);
    for (MeshPart part : other.parts) {
        part.firstIndex += firstIndex;
        part.material += int(mesh.materials.size());
        mesh.parts.push_back(part);
    }
    mesh.materials.insert(mesh.materials.end(), other.materials.begin(), other.materials.end());
}

inline Receiver floorAt(double y, double size = 2) {
    return shape("floor", makePlane(glm::dvec2(size), glm::vec3(0.8f)), {0, y, 0});
}

inline Receiver model(const char* name, double y) {
    Mesh mesh =
        io::loadGltf(std::filesystem::path(test::rootFolder()) / "models" / (std::string(name) + ".glb"));
    return shape(name, std::move(mesh), {0, y, 0});
}

/// Sun `degrees` from vertical, travelling towards +x.
inline Light sunAt(double degrees, const char* name = "sun") {
    Light light;
    light.name = name;
    light.direction = {std::sin(glm::radians(degrees)), -std::cos(glm::radians(degrees)), 0};
    return light;
}

inline Light pointLightAt(const glm::dvec3& position) {
    Light light;
    light.type = LightType::Point;
    light.position = position;
    return light;
}

/// A ball above a floor that is 3 m wide, under flat water at 0 and a sun this far from vertical.
inline Scene floorPastSphere(double degrees) {
    Scene scene;
    scene.receivers = {floorAt(-1.5, 3), shape("sphere", makeSphere(0.4, glm::vec3(0.8f)), {0, -1, 0})};
    scene.lights = {sunAt(degrees)};
    scene.water.grid = {96, 96};
    return scene;
}

inline Wave cosine(double amplitude, double wavelength, const glm::dvec2& direction) {
    Wave wave;
    wave.amplitude = amplitude;
    wave.wavelength = wavelength;
    wave.direction = direction;
    return wave;
}

inline Wave noise(double amplitude, double wavelength) {
    Wave wave;
    wave.type = WaveType::Noise;
    wave.amplitude = amplitude;
    wave.wavelength = wavelength;
    return wave;
}

} // namespace limpid::scenes
