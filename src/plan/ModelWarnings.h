#pragma once
#include <string>
#include <vector>

#include "scene/Scene.h"

namespace limpid {

/// One line each for what a receiver's model holds that the scene has as its own water, with the key that
/// leaves it out: nodes that are water by their name, their mesh's or their material's; clear sheets at the
/// water's level; closed clear bodies below it, in which nothing refracts.
std::vector<std::string> modelWarnings(const Receiver& receiver, const Water& water);

} // namespace limpid
