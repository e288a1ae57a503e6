#pragma once
#include <cstdint>
#include <utility>
#include <vector>

namespace limpid {

/// Work that a frame left out because its result could not depend on it, by kind. Counts, not estimates: what
/// they count is not done, and is done where nothing is skipped. A map is that of one receiver and light.
struct Skipped {
    std::int64_t beams =
        0; ///< not looked at for a map, over all maps: their part of the water sends none there
    std::int64_t planes = 0;       ///< left out by smart slicing: no texel belongs to them
    std::int64_t channels = 0;     ///< colours not summed, over all maps: in grey water they cannot differ
    std::int64_t lights = 0;       ///< not traced: they do not enter the water, or give nothing
    std::int64_t unlitMaps = 0;    ///< not filled: their light gives nothing, or none can reach them
    std::int64_t levelMaps = 0;    ///< not drawn again: receiver and light rest
    std::int64_t causticMaps = 0;  ///< not filled again: the water rests, too
    std::int64_t outOfView = 0;    ///< maps that no pixel of a picture can show
    std::int64_t unreadPasses = 0; ///< that prepare what nothing would read

    /// With the names that results have for them.
    std::vector<std::pair<const char*, std::int64_t>> byKind() const {
        return {{"beams", beams},
                {"planes", planes},
                {"channels", channels},
                {"lights", lights},
                {"unlit maps", unlitMaps},
                {"resting level maps", levelMaps},
                {"resting caustic maps", causticMaps},
                {"maps out of view", outOfView},
                {"unread passes", unreadPasses}};
    }
};

} // namespace limpid
