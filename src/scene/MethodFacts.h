#pragma once
#include "scene/Scene.h"

namespace limpid {

/// The differences between methods. Whoever treats some of them differently asks for a fact and not for a
/// name, so that a new method is a row here.
struct MethodFacts {
    Method method;
    std::string_view name; ///< in scene files and for `--method`
    Fill fill;             ///< the only one, unless `fills`
    bool fills = false;    ///< can be filled either way
    bool planes = false;   ///< takes light by reference planes
    bool slicing = false;  ///< leaves planes out by the depth histogram
    bool sumsBeams = false;       ///< in one pass, light is summed beam by beam in compute passes
    bool occludesPerBeam = false; ///< a beam is shaded by what is in its own way, and not in the mean light's
    bool tangentPlanes = false;   ///< beams are cut with each texel's own tangent plane
    bool photons = false;         ///< light is a grid of photons
    bool sliceImages = false;     ///< which surface a texel shows is known only once it is filled
};

inline constexpr MethodFacts methodFacts[] = {
    {.method = Method::LevelMap,
     .name = "level-map",
     .fill = Fill::OnePass,
     .fills = true,
     .planes = true,
     .sumsBeams = true},
    {.method = Method::LevelMapSmart,
     .name = "level-map-smart",
     .fill = Fill::OnePass,
     .fills = true,
     .planes = true,
     .slicing = true,
     .sumsBeams = true},
    {.method = Method::ExactBeam,
     .name = "exact-beam",
     .fill = Fill::OnePass,
     .sumsBeams = true,
     .occludesPerBeam = true,
     .tangentPlanes = true},
    {.method = Method::Volumetric,
     .name = "volumetric",
     .fill = Fill::Drawn,
     .planes = true,
     .sliceImages = true},
    {.method = Method::Stencil, .name = "stencil", .fill = Fill::Drawn, .planes = true},
    {.method = Method::PhotonSplat,
     .name = "photon-splat",
     .fill = Fill::OnePass,
     .occludesPerBeam = true,
     .photons = true},
};

constexpr const MethodFacts& factsOf(Method method) {
    return methodFacts[std::size_t(method)];
}

static_assert(
    [] {
        std::size_t row = 0;
        for (const MethodFacts& facts : methodFacts)
            if (facts.method != static_cast<Method>(row++)) return false;
        return row == std::size_t(Method::PhotonSplat) + 1;
    }(),
    "one row for each method, in their order");

/// How a method comes to its light where `asked` is.
constexpr Fill fillOf(Method method, Fill asked) {
    return factsOf(method).fills ? asked : factsOf(method).fill;
}

/// Light summed beam by beam in compute passes: beams are culled many at a time, and a
/// light's disc is more than a point.
constexpr bool sumsBeams(const CausticsSettings& settings) {
    return factsOf(settings.method).sumsBeams && fillOf(settings.method, settings.fill) == Fill::OnePass;
}

} // namespace limpid
