#pragma once
#include "scene/Scene.h"

namespace limpid {

/// What tells one method from another. Whoever treats some of them differently asks for a fact and not for a
/// name, so that a new method is a row here.
struct MethodFacts {
    Method method;
    std::string_view name; ///< in scene files and for `--method`
    bool planes;           ///< takes light by reference planes
    bool slicing;          ///< leaves planes out by the depth histogram
    bool fills;            ///< can be filled either way; else only as `fill` says
    Fill fill;
    bool sumsBeams;       ///< in one pass, light is summed beam by beam in compute passes
    bool occludesPerBeam; ///< a beam is shaded by what is in its own way, and not in the mean light's
    bool tangentPlanes;   ///< beams are cut with each texel's own tangent plane
    bool photons;         ///< light is a grid of photons
    bool sliceImages;     ///< which surface a texel shows is known only once it is filled
};

inline constexpr MethodFacts methodFacts[] = {
    {.method = Method::LevelMap,
     .name = "level-map",
     .planes = true,
     .slicing = false,
     .fills = true,
     .fill = Fill::OnePass,
     .sumsBeams = true,
     .occludesPerBeam = false,
     .tangentPlanes = false,
     .photons = false,
     .sliceImages = false},
    {.method = Method::LevelMapSmart,
     .name = "level-map-smart",
     .planes = true,
     .slicing = true,
     .fills = true,
     .fill = Fill::OnePass,
     .sumsBeams = true,
     .occludesPerBeam = false,
     .tangentPlanes = false,
     .photons = false,
     .sliceImages = false},
    {.method = Method::ExactBeam,
     .name = "exact-beam",
     .planes = false,
     .slicing = false,
     .fills = false,
     .fill = Fill::OnePass,
     .sumsBeams = true,
     .occludesPerBeam = true,
     .tangentPlanes = true,
     .photons = false,
     .sliceImages = false},
    {.method = Method::Volumetric,
     .name = "volumetric",
     .planes = true,
     .slicing = false,
     .fills = false,
     .fill = Fill::Drawn,
     .sumsBeams = false,
     .occludesPerBeam = false,
     .tangentPlanes = false,
     .photons = false,
     .sliceImages = true},
    {.method = Method::Stencil,
     .name = "stencil",
     .planes = true,
     .slicing = false,
     .fills = false,
     .fill = Fill::Drawn,
     .sumsBeams = false,
     .occludesPerBeam = false,
     .tangentPlanes = false,
     .photons = false,
     .sliceImages = false},
    {.method = Method::PhotonSplat,
     .name = "photon-splat",
     .planes = false,
     .slicing = false,
     .fills = false,
     .fill = Fill::OnePass,
     .sumsBeams = false,
     .occludesPerBeam = true,
     .tangentPlanes = false,
     .photons = true,
     .sliceImages = false},
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

/// Whether the light is summed beam by beam in compute passes: beams are passed over many at a time, and a
/// light's disc is more than a point.
constexpr bool sumsBeams(const CausticsSettings& settings) {
    return factsOf(settings.method).sumsBeams && fillOf(settings.method, settings.fill) == Fill::OnePass;
}

} // namespace limpid
