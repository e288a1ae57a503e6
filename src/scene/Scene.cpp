#include "scene/Scene.h"

namespace limpid {

namespace {
constexpr Method methods[] = {Method::LevelMap, Method::LevelMapSmart, Method::ExactBeam, Method::Volumetric};
}

std::span<const Method> allMethods() {
    return methods;
}

std::string_view methodName(Method method) {
    switch (method) {
    case Method::LevelMap:
        return "level-map";
    case Method::LevelMapSmart:
        return "level-map-smart";
    case Method::ExactBeam:
        return "exact-beam";
    case Method::Volumetric:
        return "volumetric";
    }
    return "";
}

std::optional<Method> methodFromName(std::string_view name) {
    for (const Method method : methods)
        if (methodName(method) == name) return method;
    return std::nullopt;
}

Bounds worldBounds(const Receiver& receiver) {
    Bounds bounds;
    for (const glm::dvec3& p : receiver.mesh->positions)
        bounds.add(receiver.toWorld(p));
    return bounds;
}

Bounds worldBounds(const Scene& scene) {
    Bounds bounds;
    for (const Receiver& receiver : scene.receivers) {
        const Bounds own = worldBounds(receiver);
        if (!own.empty()) bounds.add(own.min), bounds.add(own.max);
    }
    return bounds;
}

} // namespace limpid
