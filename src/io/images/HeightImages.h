#pragma once
#include <filesystem>
#include <memory>

#include "scene/HeightField.h"

namespace limpid::io {

/// The heights in an image's first channel: as they are if the file stores floating point (OpenEXR), else
/// integers from 0 to their largest value as -1 to 1 (PNG; with 8 bits the steps are coarse enough to be seen
/// in caustics). Seen from above, the image lies with x to the right and z downward.
///
/// `file` may hold one %04d, or %d: then it is a sequence, from the lowest number for which there is a file
/// to the highest. `fade` is what HeightField fades over along x and z, as a share of the image's sides.
///
/// The first frame is loaded at once, others when they are asked for; the last two are kept.
/// Throws InputError, then and later, naming the file: one that is missing from the sequence, cannot be read,
/// has numbers that are not finite or is not of the first frame's size.
std::shared_ptr<HeightSource> openHeightImages(const std::filesystem::path& file, const glm::dvec2& fade);

} // namespace limpid::io
