#pragma once
#include <optional>
#include <vector>

#include "engine/Pictures.h"

namespace limpid {

/// The order of a frame. Needs a current context, which it does not own; holds everything on the GPU that one
/// scene needs, each thing with what it was made from, and makes again only what comes out otherwise.
/// After an error, a GraphicsError for want of memory too, it stays of use: the next call makes anew what was
/// not finished.
class Engine {
  public:
    explicit Engine(gl::Context& context);

    /// Another scene, or the same with changes. Every receiver has a mesh. Choices that the scene leaves open
    /// (camera, extent of the water) are made here. Uploads receivers; all else that depends on what changed
    /// is made at the next update or picture, and nothing else is. Throws InputError or GraphicsError, and
    /// then keeps the scene before.
    void set(Scene scene);
    /// With a camera that has position and target.
    const Scene& scene() const { return _scene; }
    /// Throws InputError for what `set` would not take.
    static void requireScene(const Scene& scene, const gl::Context& context);
    /// What positions on the GPU are relative to, m: zero unless the scene is far from it.
    const glm::dvec3& origin() const { return _plan.origin; }
    const WaterPatch& waterPatch() const { return _plan.patch; }
    /// The surface as of the last update.
    const WaterMesh& waterMesh() const { return _water.mesh(); }

    /// Water at `time` (s), beams, level maps, caustic maps: thesis figure 4-17. All of them, and whole.
    void updateCaustics(double time);
    /// What pictures at `time` need: caustics that may be of an earlier time (CausticsSettings::refresh), and
    /// of fewer texels where a picture before showed them small (CausticsSettings::texelsPerPixel), under
    /// water of this time.
    void updateForPictures(double time);
    /// What the last update left out, and what was drawn since.
    /// Waits for the GPU.
    Skipped skipped() const;
    /// Beams of a light that some map was asked about in the last update. Waits for the GPU.
    std::int64_t beamsDrawn(int light) const;
    /// One entry for each light and each receiver that reaches into the water, lights outermost; after it,
    /// one for each of its side maps.
    const std::vector<MapWork>& maps() const { return _maps.all(); }
    const LightWork& light(int index) const { return _lights.work(index); }
    /// The surface that a light's mapBeams() begin at, as of the last update.
    const WaterMesh& mapMesh(const LightWork& light) const { return light.mapMesh(_water.mesh()); }

    /// Of one of maps(), after updateCaustics (levelmap/Coverage.h).
    gl::Texture coverage(const MapWork& map);

    /// Pixels on the longer side of a picture, at most.
    static int largestPicture(const gl::Context& context) { return PicturePass::largestSide(context); }
    /// The scene as its camera sees it, lit by the caustics of the last update. Waits for the GPU.
    Picture draw(glm::ivec2 size);
    /// The same piece by piece and without waiting (view/Picture.h): scene and caustics stay as they are from
    /// one call to the next. A picture has 2 · 2 samples a pixel; fewer are faster.
    /// `used`: one that is shown no longer; it may be another engine's.
    PicturePass::Sketch beginPicture(glm::ivec2 size, int perPixel, PicturePass::Sketch used = {});
    void drawRows(const PicturePass::Sketch& sketch, glm::ivec2 rows);
    /// updateForPictures for those maps that the picture can show, then draw.
    Picture render(double time, glm::ivec2 size);
    /// The same in 8-bit sRGB by the camera's exposure: RGB, rows from the top. A quarter of what
    /// `render` reads back.
    std::vector<std::uint8_t> renderToneMapped(double time, glm::ivec2 size);

    /// Off: all work is done that skipping would save (core/Skipped.h). The result is the same.
    void setSkipping(bool on) { _skipping = _reuse = on; }
    /// Off: every update makes all anew, as if everything had moved.
    void setReuse(bool on) { _reuse = on; }

    /// Gives back the GPU memory that stays for the next picture of the last one's size.
    void freePicture() { _pictures.forget(); }

    gl::PassTimers& timers() { return _timers; }

  private:
    void forgetAll();
    template <typename Work>
    auto whole(Work&& work);
    Frame frame();
    void start(double causticsTime, double time);
    void makeLights(const Frame& frame);
    void makeAll(const Frame& frame);
    void makeMap(const Frame& frame, MapWork& map);
    void makeFor(double time, glm::ivec2 size);
    std::vector<bool> makeShown(const Frame& frame, glm::ivec2 size);
    template <typename Use>
    auto picture(glm::ivec2 size, bool goesOn, Use&& use);

    gl::Context& _context;
    gl::PassTimers _timers;
    Making _making;
    std::optional<Scene> _asked; ///< as it was set
    Scene _scene;                ///< the same with a camera
    Plan _plan;                  ///< of the scene
    Receivers _receivers;
    SceneWater _water;
    Lights _lights;
    Maps _maps;
    Pictures _pictures;
    Skipped _skipped;
    double _time = 0, _causticsTime = 0; ///< of the last update, s
    bool _skipping = true, _reuse = true;
};

} // namespace limpid
