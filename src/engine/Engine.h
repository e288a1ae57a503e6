#pragma once
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "caustics/BeamTiles.h"
#include "caustics/CausticMap.h"
#include "caustics/DiscFilter.h"
#include "caustics/DrawnPlanes.h"
#include "caustics/ExactBeams.h"
#include "caustics/PhotonSplat.h"
#include "caustics/PlaneBeams.h"
#include "caustics/StencilVolumes.h"
#include "caustics/TangentPlanes.h"
#include "caustics/Volumetric.h"
#include "engine/Skipped.h"
#include "gl/Context.h"
#include "gl/TimerQuery.h"
#include "godrays/ExactShafts.h"
#include "godrays/PhotonLines.h"
#include "godrays/Tetrahedra.h"
#include "levelmap/Coverage.h"
#include "levelmap/LampShadow.h"
#include "levelmap/LevelMap.h"
#include "levelmap/PlaneDepths.h"
#include "levelmap/ReceiverGeometry.h"
#include "levelmap/SceneDepthMap.h"
#include "levelmap/SurfaceShadow.h"
#include "occlusion/Occluders.h"
#include "occlusion/TakenLight.h"
#include "plan/LampPatch.h"
#include "plan/Plan.h"
#include "scene/Scene.h"
#include "view/Picture.h"
#include "water/Beams.h"
#include "water/WaterSurface.h"

namespace limpid {

/// Beams of one more point of a light's disc.
struct DiscPoint {
    Beams beams;
    BeamTiles tiles;
};

/// The water in finer quads for a lamp that is close to it, and the beams that its maps are filled with.
struct LampWater {
    WaterPatch patch;
    WaterSurface surface;
    Beams beams;
};

/// What one light does: its beams, and what they meet first if the water were flat.
struct LightState {
    Beams beams;
    std::unique_ptr<LampWater> lampWater; ///< empty where the water's own quads are fine enough
    SceneDepth sceneDepth;
    gl::Texture surfaceShadow;   ///< empty if nothing stands out of the water
    gl::Texture lampShadow;      ///< empty unless a lamp is under water and a picture shows it
    double farthest = 1;         ///< m of water to the farthest receiver, at most
    BeamTiles tiles;             ///< where beams are passed over many at a time
    std::vector<DiscPoint> disc; ///< besides its middle, whose beams are `beams`; empty for a point far away

    /// What maps are filled with; pictures and godrays take `beams`.
    const Beams& mapBeams() const { return lampWater ? lampWater->beams : beams; }
};

/// The maps of one receiver and one light.
struct ReceiverMaps {
    int receiver = 0;
    int light = 0;
    std::shared_ptr<const Facings> facings; ///< of this receiver and light
    OrientedBox box;                        ///< in the world
    DepthGradients gradients;
    bool inReach = true; ///< whether any of the water's light may come to it
    int halvings = 0;    ///< of its size and planes, where a picture shows it small
    LevelMap level;
    TangentPlanes tangents; ///< for exact beams and photon splats only
    PlaneDepths depths;     ///< for level maps in one pass and for stencil only
    CausticMap caustics;
    gl::Texture
        taken;     ///< shares of its light (occlusion/TakenLight.h); empty where light goes through nothing
    Slices slices; ///< empty but for the volumetric method

    bool ready = false;  ///< whether all but the light is there
    bool filled = false; ///< with the light of the last update
    bool culled = false; ///< whether the last update has passed over beams of which none could reach the map
    gl::Buffer askedBeams; ///< a uint: how many it has not passed over
};

/// The order of a frame. Needs a current context, which it does not own; holds everything on the GPU that one
/// scene needs. After an error, a GraphicsError for want of memory too, it stays of use: the next call makes
/// anew what was not finished.
class Engine {
  public:
    explicit Engine(gl::Context& context);

    /// Uploads the receivers and prepares what does not depend on time. Every receiver has a mesh. Left-open
    /// choices of the scene (camera, extent of the water) are made here. Receivers that are those of the
    /// scene before stay on the GPU. Throws InputError or GraphicsError, and then keeps the scene before.
    void setScene(Scene scene);
    /// Camera, godrays, and radiance of sky and surroundings of another scene that has all else in common
    /// with this one. No caustic is made anew.
    void setLook(const Scene& scene);
    const Scene& scene() const { return _scene; }
    /// Throws InputError for what setScene would not take.
    static void requireScene(const Scene& scene, const gl::Context& context);
    /// Another method or other maps of the same scene. Frees what was made by the settings before; everything
    /// is made anew at the next update.
    void setCaustics(const CausticsSettings& settings);
    /// What positions on the GPU are relative to, m: zero unless the scene is far from it.
    const glm::dvec3& origin() const { return _plan.origin; }
    const WaterPatch& waterPatch() const { return _plan.patch; }
    /// The surface as of the last update.
    const WaterMesh& waterMesh() const { return _surface.mesh(); }

    /// Water at `time` (s), beams, level maps, caustic maps: thesis figure 4-17.
    void updateCaustics(double time);
    /// What pictures at `time` need: caustics that may be of an earlier time (CausticsSettings::refresh),
    /// under water of this one.
    void updateForPictures(double time);
    /// What the last update left out, and what was drawn since.
    /// Waits for the GPU.
    Skipped skipped() const;
    /// Beams of a light that some map was asked about in the last update. Waits for the GPU.
    std::int64_t beamsDrawn(int light) const;
    /// One entry for each light and each receiver that reaches into the water, lights outermost; after it,
    /// one for each of its further maps.
    const std::vector<ReceiverMaps>& maps() const { return _maps; }
    const LightState& light(int index) const { return _lights[std::size_t(index)]; }
    /// The surface that a light's mapBeams() begin at, as of the last update.
    const WaterMesh& mapMesh(const LightState& state) const;

    /// Of one of maps(), after updateCaustics (levelmap/Coverage.h).
    gl::Texture coverage(const ReceiverMaps& maps);

    /// Pixels on the longer side of a picture, at most.
    static int largestPicture(const gl::Context& context) { return PicturePass::largestSide(context); }
    /// The scene as its camera sees it, lit by the caustics of the last update. Waits for the GPU.
    Picture draw(glm::ivec2 size);
    /// The same piece by piece and without waiting (view/Picture.h): scene and caustics stay as they are from
    /// one call to the next. A picture has 2 · 2 samples a pixel; fewer are faster.
    PicturePass::Sketch beginPicture(glm::ivec2 size, int perPixel);
    void drawRows(const PicturePass::Sketch& sketch, glm::ivec2 rows);
    /// updateForPictures for those maps that the picture can show, then draw.
    Picture render(double time, glm::ivec2 size);

    /// Off: all work is done that skipping would save (engine/Skipped.h). The result is the same.
    void setSkipping(bool on) { _skipping = _reuse = on; }
    /// Off: every frame is made from nothing, as if all had moved.
    void setReuse(bool on) { _reuse = on; }

    gl::PassTimers& timers() { return _timers; }

  private:
    void uploadReceivers(const Scene& scene, const glm::dvec3& origin);
    template <typename Use>
    auto withPicture(glm::ivec2 size, bool goesOn, Use&& use);
    void updateSurface(double time);
    void updateLight(int light);
    void prepareDisc(int light, const LightFrameData& middle);
    void prepareLampWater(int light, const LightFrameData& frame);
    void traceLampWater(LightState& state);
    void traceBeams();
    void updateMaps(ReceiverMaps& maps);
    void updateReceiver(ReceiverMaps& maps);
    bool isDark(int light) const;
    bool isUnlit(const ReceiverMaps& maps) const;
    bool cullsBeams() const;
    const BeamCulling* cullBeams(ReceiverMaps& maps, const BeamTiles& tiles);
    void countSkipped(const ReceiverMaps& maps);
    std::vector<bool> shownMaps(glm::ivec2 size);
    void fitMaps(glm::ivec2 size);
    double causticsTime(double time) const;
    void moveWater(double time);
    void remakeFreed();
    void prepareMaps(ReceiverMaps& maps);
    LitReceiver litReceiver(const ReceiverMaps& maps) const;
    void drawLevelMap(ReceiverMaps& maps);
    void updateTangentPlanes(ReceiverMaps& maps);
    void updatePlaneDepths(ReceiverMaps& maps);
    const SceneDepth* sceneDepthOf(const ReceiverMaps& maps) const;
    const Occluders* occludersOf(const ReceiverMaps& maps) const;
    void slice(LevelMap& map);
    bool hasTranslucents() const;
    void updateTakenLight(ReceiverMaps& maps);
    void fill(ReceiverMaps& maps);
    void fillWhole(ReceiverMaps& maps);
    template <typename Pass, typename InputsOf>
    void fillInOnePass(Pass& pass, ReceiverMaps& maps, const InputsOf& inputsOf);
    void drawSlices(ReceiverMaps& maps);
    void splatPhotons(ReceiverMaps& maps);
    void freeMaps();
    void drawSceneDepth(SceneDepth& depth, const LightState& state, int mapSize);
    void drawLampShadows();
    const gl::Texture* drawGodrays(glm::ivec2 size);
    void drawGodrays(const GodrayInputs& inputs);
    bool hasFurtherMaps(int light) const;
    bool needsSceneDepth(int light) const;
    bool needsOccluders(int light) const;
    bool needsOccluders() const;

    gl::Context& _context;
    gl::PassTimers _timers;
    WaterSurface _surface;
    BeamTracer _beamTracer;
    SceneDepthPass _sceneDepthPass;
    SurfaceShadowPass _surfaceShadowPass;
    LevelMapPass _levelMapPass;
    SmartSlicing _smartSlicing;
    TangentPlanesPass _tangentPlanesPass;
    PlaneDepthsPass _planeDepthsPass;
    DrawnPlanes _drawnPlanes;
    PlaneBeams _planeBeams;
    BeamCulling _culling;
    ExactBeams _exactBeams;
    DiscFilter _discFilter;
    std::unique_ptr<Volumetric> _volumetric;         ///< made when a scene asks for it
    std::unique_ptr<StencilVolumes> _stencil;        ///< likewise
    std::unique_ptr<PhotonSplat> _photonSplat;       ///< likewise
    std::unique_ptr<CoveragePass> _coveragePass;     ///< made when light is counted
    std::unique_ptr<TakenLight> _takenLight;         ///< made for the first translucent receiver
    const gl::Texture* _godrays = nullptr;           ///< of the picture that was begun last; null for none
    std::unique_ptr<GodrayTarget> _godrayTarget;     ///< made for the first picture that shows some
    std::unique_ptr<PhotonLines> _photonLines;       ///< likewise
    std::unique_ptr<ExactShafts> _exactShafts;       ///< likewise
    std::unique_ptr<Tetrahedra> _tetrahedra;         ///< likewise
    std::unique_ptr<PicturePass> _picturePass;       ///< made for the first picture: a bake needs none
    std::unique_ptr<LampShadowPass> _lampShadowPass; ///< made for the first lamp under water in one

    bool _skipping = true, _reuse = true;
    bool _lightsReady = false;
    Skipped _skipped;
    double _waterTime = 0;         ///< of the surface, s
    bool _pictureHasLight = false; ///< the picture pass has seen the caustics as they are
    std::optional<double> _causticsTime;
    Scene _scene;
    Plan _plan; ///< of the scene
    std::vector<ReceiverGeometry> _receivers;
    std::unique_ptr<Occluders>
        _occluders; ///< of them all; made when some light's beams may meet one on their way
    std::vector<LightState> _lights;
    std::vector<ReceiverMaps> _maps;
};

} // namespace limpid
