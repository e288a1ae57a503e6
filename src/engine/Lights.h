#pragma once
#include <deque>
#include <span>
#include <vector>

#include "caustics/LightWork.h"
#include "engine/Frame.h"
#include "levelmap/PointLightShadow.h"
#include "levelmap/SurfaceShadow.h"

namespace limpid {

/// The scene's lights: their beams, and what the mean light of each meets first. What is there, made from the
/// same, is not made again.
class Lights {
  public:
    explicit Lights(gl::Context& context);

    /// As many as the scene has.
    void resize(std::size_t count) { _works.resize(count); }
    /// Nothing of theirs stays on the GPU.
    void forget();
    int count() const { return int(_works.size()); }
    const LightWork& work(int light) const { return _works[std::size_t(light)]; }

    /// Beams from the water's surface (Snell, Fresnel, flux; thesis eq. 2-8, 4-14).
    void refract(const Frame& frame, int light);
    /// What the mean light meets first, where the method asks for it.
    void findFirstHits(const Frame& frame, int light);
    /// Into a map that is nobody's, for who needs it where the method does not.
    SceneDepth firstHits(const Frame& frame, int light);
    /// What a point light below the surface sees; for pictures.
    void drawPointLightShadow(const Frame& frame, int light);

  private:
    void frameBeams(const Frame& frame, int light, LightWork& work);
    void shadeSurface(const Frame& frame, int light, LightWork& work);
    void trace(const Frame& frame, int light, LightWork& work, const LightWork::TracedFrom& from);
    void tracePointLightWater(const Frame& frame, int light, LightWork& work, const WaterPatch& patch);
    void traceDisc(const Frame& frame, int light, LightWork& work, std::span<const LightFrameData> frames);
    void drawFirstHits(const Frame& frame, int light, SceneDepth& depth);

    BeamTracer _tracer;
    SurfaceShadowPass _surfaceShadow;
    SceneDepthPass _firstHits;
    BeamTilesPass _tiles;
    std::unique_ptr<PointLightShadowPass>
        _pointLightShadow;                       ///< made for the first point light under water in a picture
    std::deque<LightWork> _works;                ///< which stay where they are: beams point into them
};

/// Texels of the map of what the mean light meets first, over LightFrameData::sceneDepthRect.
glm::ivec2 firstHitsSize(const LightFrameData& frame, int mapSize);
/// Whether the mean light may find something before a receiver that shades it, and the method asks for it.
bool needsFirstHits(const Frame& frame, int light);
/// Whether beams of a light may find something on their way, or sheets take some of it.
bool needsOccluders(const Frame& frame, int light);

} // namespace limpid
