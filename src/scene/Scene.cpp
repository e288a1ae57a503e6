#include "scene/Scene.h"

#include <algorithm>
#include <array>

#include "scene/MethodFacts.h"

namespace limpid {

namespace {
constexpr Fill fills[] = {Fill::Drawn, Fill::OnePass};
constexpr GodrayMethod godrayMethods[] = {GodrayMethod::None, GodrayMethod::PhotonLines,
                                          GodrayMethod::ExactShafts, GodrayMethod::Tetrahedra};
} // namespace

std::span<const Method> allMethods() {
    static const auto methods = [] {
        std::array<Method, std::size(methodFacts)> all{};
        std::transform(std::begin(methodFacts), std::end(methodFacts), all.begin(),
                       [](const MethodFacts& facts) { return facts.method; });
        return all;
    }();
    return methods;
}

std::string_view methodName(Method method) {
    return factsOf(method).name;
}

std::optional<Method> methodFromName(std::string_view name) {
    for (const MethodFacts& facts : methodFacts)
        if (facts.name == name) return facts.method;
    return std::nullopt;
}

std::span<const Fill> allFills() {
    return fills;
}

std::string_view fillName(Fill fill) {
    return fillNames[std::size_t(fill)];
}

std::optional<Fill> fillFromName(std::string_view name) {
    for (const Fill fill : fills)
        if (fillName(fill) == name) return fill;
    return std::nullopt;
}

std::span<const GodrayMethod> allGodrayMethods() {
    return godrayMethods;
}

std::string_view godrayMethodName(GodrayMethod method) {
    return godrayMethodNames[std::size_t(method)];
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
