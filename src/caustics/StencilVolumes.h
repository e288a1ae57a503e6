#pragma once
#include "caustics/BeamFootprints.h"
#include "caustics/CausticMap.h"
#include "gl/Program.h"
#include "levelmap/LevelMap.h"
#include "levelmap/PlaneDepths.h"
#include "scene/Scene.h"
#include "water/Beams.h"

namespace limpid {

/// Caustics on objects by depth and stencil test (Iwasaki, Dobashi and Nishita 2002, 4.3), in a receiver's
/// map seen from its box: each illumination volume is cut into sub-volumes, and those that may hold something
/// of the receiver are drawn. Back faces mark the stencil where they lie behind the receiver; front faces add
/// their light where it is marked and they lie before it, and clear the mark. What was added is multiplied
/// with an image of the receiver in parallel light: the paper's approximation of the cosine, and its shadows.
///
/// Sampling is at texel centres. A face that runs along the light of flat water takes none.
class StencilVolumes {
  public:
    explicit StencilVolumes(gl::Context& context);

    /// Clears and fills `caustics`. `beams` are those of the level map's light, `depths` those of the map, as
    /// many sub-volumes as it has planes.
    void fill(CausticMap& caustics, const LevelMap& map, const PlaneDepths& depths, const Beams& beams,
              const WaterMesh& surface, const Water& water);
    /// Gives back its memory until the next fill.
    void free() {
        _footprints.free();
        _ranges = {};
        _draw = {};
    }

  private:
    void findSubVolumes(const LevelMap& map, const Beams& beams, const WaterMesh& surface);
    void drawObjects(const LevelMap& map) const;
    void drawSubVolumes(const Beams& beams, const Water& water) const;
    void multiply(const LevelMap& map) const;
    gl::Context& _context;
    BeamFootprints _footprints;
    gl::Program _find, _objects, _volumes, _light;
    gl::Buffer _ranges; ///< a beam: its first sub-volume, and how many; ints
    gl::Buffer _draw;   ///< what glDrawArraysIndirect reads
    gl::VertexArray _noVertices;
};

} // namespace limpid
