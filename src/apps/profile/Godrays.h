#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/ImageErrors.h"
#include "core/Statistics.h"
#include "gl/Context.h"
#include "io/toml/ProfileFile.h"

namespace limpid::apps {

/// What was measured of one way to draw light in the water.
struct GodrayResult {
    std::string profile, scene;
    GodraySettings settings;
    Spread ms;                           ///< of its pass, from beams to radiance
    std::int64_t bytes = 0;              ///< that it holds on the GPU
    std::optional<ImageErrors> error;    ///< of what it adds to the picture, against single scattering
    std::optional<double> standardError; ///< nMAE that chance in the reference alone makes
};

/// Measures every scene of the profile with each of its `godrays`, round after round: `warmup` pictures, then
/// a timed one. Ground truth is kept in `references`. Throws InputError, for a camera above the water too.
std::vector<GodrayResult> profileGodrays(gl::Context& context, const io::Profile& profile,
                                         const std::filesystem::path& references, bool quiet);

/// `godrays.csv`: one line a result.
std::string godraysCsv(const std::vector<GodrayResult>& results);
/// A table for the terminal.
void printGodrays(const std::vector<GodrayResult>& results);

} // namespace limpid::apps
