#include "scene/Scene.h"

namespace limpid {

namespace {
constexpr Fill fills[] = {Fill::Drawn, Fill::OnePass};
constexpr Method methods[] = {Method::LevelMap,   Method::LevelMapSmart, Method::ExactBeam,
                              Method::Volumetric, Method::Stencil,       Method::PhotonSplat};
constexpr GodrayMethod godrayMethods[] = {GodrayMethod::None, GodrayMethod::PhotonLines,
                                          GodrayMethod::ExactShafts, GodrayMethod::Tetrahedra};
} // namespace

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
    case Method::Stencil:
        return "stencil";
    case Method::PhotonSplat:
        return "photon-splat";
    }
    return "";
}

std::optional<Method> methodFromName(std::string_view name) {
    for (const Method method : methods)
        if (methodName(method) == name) return method;
    return std::nullopt;
}

std::span<const Fill> allFills() {
    return fills;
}

std::string_view fillName(Fill fill) {
    switch (fill) {
    case Fill::Drawn:
        return "drawn";
    case Fill::OnePass:
        return "one-pass";
    }
    return "";
}

std::optional<Fill> fillFromName(std::string_view name) {
    for (const Fill fill : fills)
        if (fillName(fill) == name) return fill;
    return std::nullopt;
}

bool hasFills(Method method) {
    return method == Method::LevelMap || method == Method::LevelMapSmart;
}

Fill fillOf(Method method, Fill asked) {
    if (hasFills(method)) return asked;
    return method == Method::ExactBeam || method == Method::PhotonSplat ? Fill::OnePass : Fill::Drawn;
}

bool goesOwnWay(Method method) {
    return method == Method::ExactBeam || method == Method::PhotonSplat;
}

bool sumsBeams(const CausticsSettings& settings) {
    return settings.method != Method::PhotonSplat && fillOf(settings.method, settings.fill) == Fill::OnePass;
}

std::span<const GodrayMethod> allGodrayMethods() {
    return godrayMethods;
}

std::string_view godrayMethodName(GodrayMethod method) {
    switch (method) {
    case GodrayMethod::None:
        return "none";
    case GodrayMethod::PhotonLines:
        return "photon-lines";
    case GodrayMethod::ExactShafts:
        return "exact-shafts";
    case GodrayMethod::Tetrahedra:
        return "tetrahedra";
    }
    return "";
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

std::string receiverNames(const Scene& scene) {
    std::string names;
    for (const Receiver& receiver : scene.receivers)
        names += (names.empty() ? "" : "+") + receiver.name;
    return names;
}

} // namespace limpid
