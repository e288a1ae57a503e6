#pragma once
#include "levelmap/Facings.h"
#include "reference/FaceSorting.h"

namespace limpid {

/// The bake's sorting of faces over maps, as ray tracers read it.
inline reference::FaceSorting sortingOf(const Facings& facings) {
    return {facings.light, Facings::steep, facings.axes, facings.used, facings.sheet};
}

} // namespace limpid
