#pragma once

#include "Mesh.h"

namespace limpid::models {

/// A closed shell with at most `triangles` triangles, or as few as leave it a closed manifold without
/// slivers: edges are collapsed, the one that changes the surface least first (Garland and Heckbert 1997).
/// Colours are dropped.
Shell simplified(const Shell& shell, std::size_t triangles);

} // namespace limpid::models
