#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <tuple>

#include "io/bake/BakedFolder.h"
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
    /// Fingerprint of the light, map size, water grid: what the key of a scene's maps follows from.
    using Planned = std::tuple<std::uint64_t, int, int, int>;

    /// The name of the folder that the maps are kept in. What a map's size is depends on the water's grid
    /// too, and to plan all maps takes a while: done once for each.
    std::string keyOf(const Scene& scene);
    std::uint64_t sizesOf(const Scene& scene) const; ///< a number that differs with the maps' sizes
    io::Bake trace(const Scene& scene) const;

    std::filesystem::path _folder;
    std::int64_t _photons;
    double _time;
    bool _quiet;
    std::map<Planned, std::string> _keys; ///< of the scenes seen so far
    std::string _key;                     ///< of `_maps`
    io::Bake _maps;
};

} // namespace limpid::apps
