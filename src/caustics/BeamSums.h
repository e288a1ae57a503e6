#pragma once
#include "caustics/BeamTiles.h"
#include "caustics/DiscFilter.h"
#include "caustics/MapWork.h"

namespace limpid {

/// Fills a map by a pass that sums beam by beam: for each point of the light's disc the beams that may reach
/// it.
class BeamSums {
  public:
    explicit BeamSums(gl::Context& context) : _context(context), _culling(context), _discFilter(context) {}

    /// `pyramid`: the depths of the map's surface, of the kind `depths`. `inputsOf(beams, culling, points)`
    /// is what `pass` takes.
    template <typename Pass, typename InputsOf>
    void fill(Pass& pass, MapWork& map, const MapInputs& inputs, const gl::Texture& pyramid,
              BeamCulling::Depths depths, const InputsOf& inputsOf);

    /// Gives back its memory until the next map.
    void free() { _culling.free(), _discFilter.free(); }

  private:
    const BeamCulling* cull(MapWork& map, const BeamTiles& tiles, const gl::Texture& pyramid,
                            BeamCulling::Depths depths);

    gl::Context& _context;
    BeamCulling _culling;
    DiscFilter _discFilter;
};

/// The middle of the disc goes last, so that it is the one whose culled beams are counted.
template <typename Pass, typename InputsOf>
void BeamSums::fill(Pass& pass, MapWork& map, const MapInputs& inputs, const gl::Texture& pyramid,
                    BeamCulling::Depths depths, const InputsOf& inputsOf) {
    const LightWork& work = inputs.work;
    const int points = 1 + int(work.disc.size());
    for (const DiscPoint& point : work.disc)
        pass.deposit(inputsOf(point.beams, cull(map, point.tiles, pyramid, depths), points));
    const auto middle = inputsOf(work.mapBeams(), cull(map, work.tiles, pyramid, depths), points);
    pass.deposit(middle);
    pass.resolve(map.caustics, middle);
    if (work.disc.empty()) return;
    const double farthest = inputs.plan.lights[std::size_t(map.plan.light)].farthest;
    _discFilter.apply(map.caustics, {map.level, work.beams, inputs.light, inputs.scene.water, farthest});
}

} // namespace limpid
