#pragma once
#include "caustics/CausticMap.h"
#include "caustics/PlaneDrawer.h"
#include "caustics/Slices.h"
#include "levelmap/LevelMap.h"

namespace limpid {

/// The method that the level map was measured against (thesis 5.2.1, figures 5-1 to 5-4; after Iwasaki,
/// Dobashi and Nishita 2003): the receiver is drawn into a slice image for each plane, the caustics are drawn
/// for each slice and multiplied with it, and the slices are combined.
///
/// A slice knows nothing of those above it, so the underside of a sphere is lit in them like its top (alone;
/// beside other receivers, the test that shades by those darkens it too). The thesis does not say how its
/// slices are combined; here a texel of the maps is that of the topmost slice with surface there, which is
/// what the light sees first, as in every other method. The light of the slices below it gets into no map.
class Volumetric {
  public:
    explicit Volumetric(gl::Context& context);

    /// Figures 5-2 and 5-3. `map` is prepared (levelmap/LevelMap.h).
    void drawSlices(Slices& slices, const LevelMap& map, const LitReceiver& receiver);
    /// Figure 5-4, all but its last step. `beams` are those of the level map's light.
    void drawCaustics(const Slices& slices, const LevelMap& map, const Beams& beams, const WaterMesh& surface,
                      const Water& water);
    /// Fills `caustics` and the textures of `map`.
    void combine(CausticMap& caustics, LevelMap& map, const Slices& slices);
    /// Gives back its memory until caustics are drawn again.
    void free() { _drawer.free(); }

  private:
    void multiply(int plane);
    gl::Context& _context;
    gl::Program _slice, _multiply, _combine;
    PlaneDrawer _drawer;
    gl::VertexArray _noVertices;
};

} // namespace limpid
