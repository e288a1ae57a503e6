#pragma once
#include <memory>
#include <vector>

#include "engine/Frame.h"
#include "engine/Maps.h"
#include "view/Picture.h"

namespace limpid {

/// Draws pictures of a frame's maps. Its passes are made for the first picture: a bake needs none.
class Pictures {
  public:
    explicit Pictures(gl::Context& context);
    ~Pictures();

    /// What a picture is drawn of besides the frame.
    struct Subject {
        const Lights& lights;
        const Maps& maps;
        const std::vector<bool>& shown; ///< which maps it needs
        const WaterMesh& surface;       ///< as the picture shows it
        double waterHeight;             ///< heightAtCamera
    };
    /// Of the surface at `time` (s), m in the world (view/ViewFrame.h). Waits for the GPU at most once for
    /// each surface and place.
    double heightAtCamera(const Frame& frame, double time);
    /// Light in the water, for a picture of `size` and its pieces.
    void drawGodrays(const Frame& frame, Lights& lights, const WaterMesh& surface, double waterHeight,
                     glm::ivec2 size);
    /// As PicturePass has them.
    Picture draw(const Frame& frame, const Subject& subject, glm::ivec2 size);
    std::vector<std::uint8_t> drawToneMapped(const Frame& frame, const Subject& subject, glm::ivec2 size);
    PicturePass::Sketch begin(const Frame& frame, const Subject& subject, glm::ivec2 size, int perPixel,
                              PicturePass::Sketch used);
    void drawRows(const Frame& frame, const Subject& subject, const PicturePass::Sketch& sketch,
                  glm::ivec2 rows);
    /// True while targets of the last picture are on the GPU; `forget` gives them back.
    bool holdsTargets() const;
    void forget();

  private:
    struct Passes;
    struct StandsIn {
        SceneWater::Moment surface;
        glm::dvec3 camera; ///< m in the world
        bool operator==(const StandsIn&) const = default;
    };
    template <typename Use>
    auto withInputs(const Frame& frame, const Subject& subject, Use&& use);

    gl::Context& _context;
    std::unique_ptr<Passes> _passes;
    Kept<StandsIn> _stands;
    double _waterHeight = 0;               ///< heightAtCamera
    const gl::Texture* _godrays = nullptr; ///< of the picture that was begun last; null for none
};

/// Which maps a picture of `size` needs: those whose receiver it may show in a light that gives any.
std::vector<bool> shownMaps(const Frame& frame, const Lights& lights, const Maps& maps, double waterHeight,
                            glm::ivec2 size);
/// How often a map may be halved and still have the texels that a picture of `size` asks for where it shows
/// most of them (CausticsSettings::texelsPerPixel).
int halvingsFor(const Frame& frame, const MapWork& map, glm::ivec2 size);

} // namespace limpid
