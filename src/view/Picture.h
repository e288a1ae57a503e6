#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "core/Picture.h"
#include "gl/Context.h"
#include "scene/Scene.h"
#include "view/ReceiverPass.h"
#include "view/ViewFrame.h"
#include "view/WaterPass.h"

namespace limpid {

/// Luminance, after exposure, that is shown as white. A white wall in the default sun stays below it; only a
/// caustic's core reaches it.
inline constexpr float whiteLuminance = 4.0f;

/// 8-bit sRGB of a picture: exposure in stops, then Reinhard's curve on luminance, dithered.
std::vector<std::uint8_t> toneMapped(const Picture& picture, double exposure);

/// Receivers lit by their caustic maps, through the water surface as the scene's camera sees it.
class PicturePass {
  public:
    /// A picture in the making: what it needs, and what is drawn of it.
    class Sketch {
      public:
        /// Linear radiance, RGBA32F, W/(m² sr), row 0 at the bottom, alpha without meaning; of every pixel
        /// `perPixel` · `perPixel` samples, side by side.
        const gl::Texture& samples() const { return _radiance; }
        int perPixel() const { return _perPixel; }

      private:
        friend class PicturePass;
        /// Receivers as seen through the surface or in it: what is drawn into and looked up in.
        struct View {
            gl::Texture radiance, distance, depth;
            gl::Framebuffer target;
            View() = default;
            View(gl::Ledger& ledger, const char* kind, glm::ivec2 size);
        };
        int _perPixel = 1;
        ViewFrameData _frame;
        gl::Buffer _view;
        View _refracted, _mirrored;
        gl::Texture _radiance, _depth;
        gl::Framebuffer _target;
    };

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
        const gl::Texture* godrays = nullptr; ///< radiance to be added (shaders/view/godrays.frag); or none
    };
    Picture draw(const Inputs& inputs, glm::ivec2 size);

    /// The same picture piece by piece and left on the GPU, for who has to answer a user in between. `begin`
    /// draws what all pieces look things up in; the inputs stay the same until the last piece.
    Sketch begin(const Inputs& inputs, glm::ivec2 size, int perPixel);
    /// The pixels of `rows` (from the bottom; first, and one past the last).
    void drawRows(const Inputs& inputs, const Sketch& sketch, glm::ivec2 rows);

  private:
    void addGodrays(const Inputs& inputs, const gl::Texture& radiance, const gl::Texture& depth, float near);
    ReceiverPass::Inputs receiverInputs(const Inputs& inputs, const ViewFrameData& frame) const;
    void drawView(const ReceiverPass::Inputs& receivers, const gl::Framebuffer& target, Side side, Way way);

    gl::Context& _context;
    ReceiverPass _receivers;
    WaterPass _water;
    std::optional<gl::Program> _godrays; ///< made for the first picture with some
    gl::VertexArray _noVertices;
};

} // namespace limpid
