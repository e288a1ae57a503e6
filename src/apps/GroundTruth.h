#pragma once
#include <filesystem>

#include "io/BakedFolder.h"
#include "scene/Scene.h"

namespace limpid::apps {

/// Whether this build can compute ground truth.
bool canTraceGroundTruth();

/// Ray-traced maps of a scene, kept in a folder: a scene, a time and a number of photons are traced once.
class GroundTruth {
  public:
    /// `folder` is made when there is something to keep. `quiet`: no progress on the terminal.
    GroundTruth(std::filesystem::path folder, std::int64_t photons, double time, bool quiet);

    /// The maps of `scene` on the texels that a bake of it has; from the folder if they are there. Throws
    /// InputError.
    const io::Bake& maps(const Scene& scene);

  private:
    std::filesystem::path _folder;
    std::int64_t _photons;
    double _time;
    bool _quiet;
    std::string _key; ///< of `_maps`
    io::Bake _maps;
};

} // namespace limpid::apps
