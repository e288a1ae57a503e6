#include "io/gltf/Views.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>

#include "io/gltf/Compressed.h"

namespace limpid::io {

namespace {

constexpr double brightest = 6;   ///< W/m², about that of the sun that a model without lights gets
constexpr double darkest = 1e-30; ///< lux; no light, and too little to divide by
constexpr std::size_t maxLights = 64;

bool isFinite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Of unit length, or none for a vector that has no direction.
std::optional<glm::dvec3> unit(const glm::dvec3& v) {
    const double length = glm::length(v);
    if (!(length > 0) || !std::isfinite(length)) return std::nullopt;
    return v / length;
}

/// Lights and cameras look along −z.
std::optional<glm::dvec3> forward(const glm::dmat4& transform) {
    return unit(-glm::dvec3(transform[2]));
}

/// What the source gives: lux or candela, by colour; none unless it is light.
std::optional<glm::dvec3> strength(const tinygltf::Light& source) {
    glm::dvec3 color(1);
    for (std::size_t c = 0; source.color.size() == 3 && c < 3; ++c)
        color[static_cast<int>(c)] = source.color[c];
    color *= source.intensity;
    const bool good = isFinite(color) && glm::all(glm::greaterThanEqual(color, glm::dvec3(0)));
    return good && color != glm::dvec3(0) ? std::optional(color) : std::nullopt;
}

/// False for a cone that the format does not allow.
bool addCone(const tinygltf::SpotLight& spot, const std::optional<glm::dvec3>& axis, Light& light) {
    constexpr double widest = 0.5 * std::numbers::pi;
    const double inner = spot.innerConeAngle, outer = spot.outerConeAngle;
    if (!axis || !(inner >= 0 && inner < outer && outer <= widest * (1 + 1e-6))) return false;
    light.direction = *axis;
    light.innerCone = glm::degrees(inner);
    light.outerCone = glm::degrees(std::min(outer, widest));
    return true;
}

std::optional<Light> convert(const tinygltf::Light& source, const glm::dmat4& transform) {
    const std::optional<glm::dvec3> color = strength(source);
    const std::optional<glm::dvec3> direction = forward(transform);
    Light light;
    light.name = source.name;
    light.position = glm::dvec3(transform[3]);
    if (!color || !isFinite(light.position)) return std::nullopt;
    if (source.type == "directional") {
        if (!direction) return std::nullopt;
        light.direction = *direction;
        light.irradiance = *color;
        return light;
    }
    if (source.type != "point" && source.type != "spot") return std::nullopt;
    light.type = LightType::Point;
    light.intensity = *color;
    if (source.type == "spot" && !addCone(source.spot, direction, light)) return std::nullopt;
    return light;
}

/// At `center`, the strongest colour, on a plane facing the light; of a spot, as if it looked there.
double irradiance(const Light& light, const glm::dvec3& center) {
    const auto strongest = [](const glm::dvec3& c) { return std::max({c.x, c.y, c.z}); };
    if (light.type == LightType::Directional) return strongest(light.irradiance);
    const glm::dvec3 way = center - light.position;
    return strongest(light.intensity) / glm::dot(way, way);
}

std::optional<Camera> convert(const tinygltf::Camera& source, const glm::dmat4& transform,
                              const glm::dvec3& center) {
    const std::optional<glm::dvec3> ahead = forward(transform);
    const std::optional<glm::dvec3> up = unit(glm::dvec3(transform[1]));
    const double fov = source.perspective.yfov;
    Camera camera;
    camera.position = glm::dvec3(transform[3]);
    if (source.type != "perspective" || !ahead || !up || !isFinite(*camera.position)) return std::nullopt;
    if (!(fov > 0 && fov < std::numbers::pi)) return std::nullopt;
    const double distance = glm::dot(center - *camera.position, *ahead);
    camera.target = *camera.position + *ahead * (distance > 0 ? distance : 1.0);
    camera.up = *up;
    camera.verticalFov = glm::degrees(fov);
    if (*camera.target == *camera.position) return std::nullopt; // too far out for a difference
    return camera;
}

} // namespace

std::vector<Light> readLights(const GltfFile& file, const std::vector<SceneNode>& nodes,
                              const glm::dvec3& center) {
    std::vector<Light> lights;
    double most = 0;
    for (const SceneNode& node : nodes) {
        const auto* object = extensionObject(file.model.nodes[node.node].extensions, "KHR_lights_punctual");
        if (!object || lights.size() == maxLights) continue;
        const std::string place = fmt::format("nodes[{}].KHR_lights_punctual", node.node);
        const int index = indexMember(file, place, *object, "light");
        file.requireIndex(place + ".light", index, file.model.lights.size());
        const auto light = convert(file.model.lights[static_cast<std::size_t>(index)], node.transform);
        const double given = light ? irradiance(*light, center) : 0;
        if (!(given > darkest) || !std::isfinite(given)) continue;
        most = std::max(most, given);
        lights.push_back(*light);
    }
    for (Light& light : lights)
        (light.type == LightType::Point ? light.intensity : light.irradiance) *= brightest / most;
    return lights;
}

std::vector<Camera> readCameras(const GltfFile& file, const std::vector<SceneNode>& nodes,
                                const glm::dvec3& center) {
    std::vector<Camera> cameras;
    for (const SceneNode& node : nodes) {
        const int index = file.model.nodes[node.node].camera;
        if (index == -1) continue;
        const auto& source = file.model.cameras[static_cast<std::size_t>(index)];
        if (const auto camera = convert(source, node.transform, center)) cameras.push_back(*camera);
    }
    return cameras;
}

} // namespace limpid::io
