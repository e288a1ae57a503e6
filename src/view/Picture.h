#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "gl/Context.h"
#include "scene/Scene.h"
#include "view/ReceiverPass.h"
#include "view/ViewFrame.h"
#include "view/WaterPass.h"

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

    struct Inputs {
        const Scene& scene; ///< its camera's position and target are set
        const glm::dvec3& origin;
        const WaterPatch& patch;
        const WaterMesh& surface;
        const SideBounds& sides;
        std::span<const ReceiverGeometry> receivers;
        std::span<const Lit> lit;
        std::span<const Beams* const> lights; ///< in the scene's order
        const gl::Texture* godrays =
            nullptr; ///< radiance to be added (shaders/view/godrays.frag); null: none
    };
    Picture draw(const Inputs& inputs, glm::ivec2 size);

  private:
    void addGodrays(const Inputs& inputs, const gl::Texture& radiance, const gl::Texture& depth, float near);
    void drawView(const ReceiverPass::Inputs& receivers, const gl::Framebuffer& target, Side side, Way way);

    gl::Context& _context;
    ReceiverPass _receivers;
    WaterPass _water;
    std::optional<gl::Program> _godrays; ///< made for the first picture with some
    gl::VertexArray _noVertices;
};

} // namespace limpid
