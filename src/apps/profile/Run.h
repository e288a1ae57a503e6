#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "apps/profile/Godrays.h"
#include "core/ImageErrors.h"
#include "core/Statistics.h"
#include "engine/Engine.h"
#include "io/toml/ProfileFile.h"

namespace limpid::apps {

/// One map of a combination.
struct MeasuredMap {
    std::string receiver, light;
    int facing = 0;
    glm::ivec2 size{0};
    int planesDrawn = 0;
};

/// What was measured of one combination.
struct ProfileResult {
    std::string profile, scene, receiver, method, fill;
    int planes = 0, mapSize = 0;
    glm::ivec2 grid{0};
    Spread wall, caustics;                                   ///< ms
    std::vector<std::pair<std::string, double>> gpu;         ///< median ms by pass, in the order of a frame
    std::vector<std::pair<std::string, std::int64_t>> bytes; ///< by kind, total and peak last
    int planesDrawn = 0;                                     ///< of all maps
    std::int64_t beamsDrawn = 0;
    std::vector<std::pair<const char*, std::int64_t>> skipped; ///< by what was left out of the frame
    std::vector<MeasuredMap> maps;
    std::optional<ImageErrors> error;      ///< against the ground truth
    std::optional<double> standardError;   ///< nMAE that chance in the ground truth alone may make
    std::optional<ImageErrors> difference; ///< from the baseline's maps
};

/// Texels by reference plane of a receiver's first map.
struct DepthHistogram {
    std::string profile, scene, receiver;
    std::vector<std::uint32_t> texels; ///< by plane, from the top down
};

struct ProfileOutcome {
    std::vector<ProfileResult> results;
    std::vector<DepthHistogram> histograms;
    std::vector<GodrayResult> godrays;
};

struct ProfileRunOptions {
    std::filesystem::path references; ///< folder that ground truth is kept in
    bool quiet = false;
    /// Called now and then with what was measured so far: a run of an hour that is stopped leaves that.
    std::function<void(const ProfileOutcome&)> keep;
};

/// Measures every combination of the profile's lists, round after round. Within a visit: `warmup` updates,
/// then a timed frame, which does the whole caustic work unless the profile lets it reuse what the one before
/// it made. Throws InputError.
ProfileOutcome runProfile(gl::Context& context, const io::Profile& profile, const ProfileRunOptions& options);

/// The name that results have for a scene file.
std::string sceneName(const std::filesystem::path& file);

} // namespace limpid::apps
