#pragma once
#include <filesystem>
#include <optional>
#include <vector>

#include "scene/Scene.h"

namespace limpid::apps {

/// What single scattering adds to a picture.
struct ScatteredPicture {
    std::vector<float> rgb;   ///< W/(m² sr), rows from the top
    double standardError = 0; ///< nMAE that chance alone makes
};

/// Traced by `photons` for each light, and kept in `folder`: a scene, a view, a time and a number of photons
/// are traced once. Nothing in a build without a tracer. The camera has position and target. Throws
/// InputError.
std::optional<ScatteredPicture> scatteredPicture(const std::filesystem::path& folder, const std::string& name,
                                                 const Scene& scene, double time, std::int64_t photons,
                                                 glm::ivec2 size);

} // namespace limpid::apps
