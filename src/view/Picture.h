#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "caustics/CausticMap.h"
#include "gl/Context.h"
#include "gl/Program.h"
#include "levelmap/LevelMap.h"
#include "levelmap/ReceiverGeometry.h"
#include "scene/Scene.h"
#include "water/Beams.h"
#include "water/FlatWater.h"
#include "water/WaterSurface.h"

namespace limpid {

/// Linear radiance, RGB floats, W/(m² sr), rows from the top.
struct Picture {
    glm::ivec2 size{0};
    std::vector<float> rgb;
};

/// 8-bit sRGB of a picture: exposure in stops, then Reinhard's curve on luminance, dithered.
std::vector<std::uint8_t> toneMapped(const Picture& picture, double exposure);

/// Receivers lit by their caustic maps, through the water surface as the scene's camera sees it.
class PicturePass {
  public:
    explicit PicturePass(gl::Context& context);

    /// Pixels on the longer side, at most.
    static int largestSide(const gl::Context& context);

    struct Lit {
        int receiver;
        const LevelMap* level;
        const CausticMap* caustics;
    };
    struct Inputs {
        const Scene& scene; ///< its camera's position and target are set
        const glm::dvec3& origin;
        const WaterPatch& patch;
        const WaterMesh& surface;
        std::span<const ReceiverGeometry> receivers;
        std::span<const Lit> lit;
        std::span<const Beams* const> lights; ///< in the scene's order
    };
    Picture draw(const Inputs& inputs, glm::ivec2 size);

  private:
    gl::Texture castMap(const Lit& lit);
    void addCaustics(const Inputs& inputs, std::size_t receiver);
    void addDirectLight(const Inputs& inputs, std::size_t receiver, bool underwater);
    void drawReceivers(const Inputs& inputs, const gl::Framebuffer& target, bool underwater);
    void drawWater(const Inputs& inputs);
    void drawGrid(const Inputs& inputs);
    void drawHorizon(const Inputs& inputs);

    gl::Context& _context;
    gl::Program _castMap, _receiver, _water, _underwaterScreen;
};

} // namespace limpid
