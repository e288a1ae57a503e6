#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "apps/viewer/Keys.h"
#include "apps/viewer/MapImages.h"
#include "apps/viewer/Stage.h"
#include "apps/viewer/State.h"

namespace limpid::viewer {

/// What shows how the method works: maps and depth histogram of the picked receiver, and over the picture its
/// box, its planes and some beams.
class Understanding {
  public:
    explicit Understanding(gl::Context& context) : _context(context) {}

    /// Follows the stage: `changed` after each of its new pictures.
    void update(const State& state, Stage& stage, bool changed);
    /// Inside of a window of Dear ImGui.
    void panel(State& state, Stage& stage);
    /// Over the picture.
    void overlay(const State& state, Stage& stage, const Area& picture) const;

  private:
    const MapWork* shownMaps(const State& state, Stage& stage) const;
    void traceBeams(const State& state, Stage& stage);
    void mapChoice(State& state, Stage& stage);
    void histogram(const MapWork& maps) const;

    gl::Context& _context;
    std::unique_ptr<MapImages> _images;
    const MapWork* _maps = nullptr; ///< that `_images` show
    int _facing = 0;
    std::optional<int> _selected; ///< for which all of it is
    bool _stale = true, _beamsStale = true;
    std::vector<std::uint32_t> _histogram;
    std::vector<std::vector<glm::dvec3>> _beams; ///< each a line in the world
};

} // namespace limpid::viewer
