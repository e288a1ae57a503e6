#pragma once
#include <cstdint>

#include "scene/Scene.h"

namespace limpid {

/// A number that changes with whatever light depends on: water, lights, shapes and cut-outs of the receivers;
/// not with colours, camera or settings of a method. The same on every machine of one byte order.
std::uint64_t lightFingerprint(const Scene& scene);

} // namespace limpid
