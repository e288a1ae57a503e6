#include "scene/Scene.h"

namespace limpid {

namespace {
constexpr std::pair<Method, std::string_view> methodNames[] = {
    {Method::LevelMap, "level-map"},
    {Method::LevelMapSmart, "level-map-smart"},
    {Method::ExactBeam, "exact-beam"},
};
}

std::string_view methodName(Method method) {
    for (const auto& [value, name] : methodNames)
        if (value == method) return name;
    return "";
}

std::optional<Method> methodFromName(std::string_view name) {
    for (const auto& [value, known] : methodNames)
        if (known == name) return value;
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
