#pragma once
#include <optional>

#include "core/Bounds.h"
#include "scene/Mesh.h"

namespace limpid {

/// A hollow that holds water and is open to the sky: a pool, a tub, an aquarium without a lid, a lake.
struct Basin {
    Bounds water;     ///< of the water that fills it to the rim, within a 96th of the mesh's size; m
    double depth = 0; ///< of that water in the mean, m
    /// y of the water's surface as the mesh's author modelled it: a clear, level sheet in the basin, or the
    /// top of a clear body; none without one.
    std::optional<double> surface;
};

/// The basin that a mesh (Y up) has, if it has one. Water is poured over the mesh, in 96 cells a side, and
/// what cannot run off down any way stays: through a door, out of a box on its side, below a table it runs
/// off. A basin is what stays open to the sky over three quarters of its plan, is not a mere puddle in that,
/// and not one of many; a shallow one lies at the mesh's foot, unlike a flat roof's. Clear sheets count as
/// the water's own surface where that leaves a basin, else as glass that holds water.
std::optional<Basin> findBasin(const Mesh& mesh);

} // namespace limpid
