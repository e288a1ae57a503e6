#include "caustics/BeamSums.h"

namespace limpid {

/// Null where all beams are to be asked.
const BeamCulling* BeamSums::cull(MapWork& map, const BeamTiles& tiles, const gl::Texture& pyramid,
                                  BeamCulling::Depths depths) {
    if (tiles.quads == glm::ivec2(0)) return nullptr;
    _culling.cull(tiles, map.level, pyramid, depths);
    if (!map.askedBeams.id()) map.askedBeams = gl::Buffer(_context.ledger(), "beam tiles", 4);
    map.askedBeams.copy(_culling.kept(), BeamCulling::beamCountOffset, sizeof(std::uint32_t));
    map.culled = true;
    return &_culling;
}

} // namespace limpid
