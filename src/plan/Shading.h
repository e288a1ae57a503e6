#pragma once
#include <vector>

#include "plan/Plan.h"

namespace limpid {

/// Whether `box` meets the hull of two boxes.
bool meetsHull(const Bounds& box, const Bounds& a, const Bounds& b);

/// The receivers that may keep light in the water from a map's receiver, itself among them, in rising order:
/// all whose bounds meet the hull of the receiver and the places where its light enters. Under any waves, and
/// never too few.
std::vector<int> mayShade(const Scene& scene, const Plan& plan, const PlannedMap& map);

} // namespace limpid
