#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "core/Picture.h"
#include "gl/Context.h"
#include "scene/Scene.h"
#include "view/PictureResolve.h"
#include "view/ReceiverPass.h"
#include "view/ViewFrame.h"
#include "view/WaterPass.h"

namespace limpid {

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
            /// Makes it unless it is there in that size.
            void fit(gl::Ledger& ledger, const char* kind, glm::ivec2 size);
            void clear() const;
        };
        int _perPixel = 1;
        ViewFrameData _frame;
        gl::Buffer _view;
        View _refracted, _mirrored;
        gl::Texture _radiance, _depth;
        gl::Framebuffer _target, _withoutDepth;
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
        double waterHeight; ///< heightAtCamera
        std::span<const ReceiverGeometry> receivers;
        std::span<const Lit> lit;
        std::span<const Beams* const> lights; ///< in the scene's order
        const gl::Texture* godrays = nullptr; ///< radiance to be added (shaders/view/godrays.frag); or none
    };
    /// Waits for the GPU. Its targets stay for the next picture of that size.
    Picture draw(const Inputs& inputs, glm::ivec2 size);
    /// The same in 8-bit sRGB (view/PictureResolve.h) by the camera's exposure.
    std::vector<std::uint8_t> drawToneMapped(const Inputs& inputs, glm::ivec2 size);
    bool holdsTargets() const { return _drawn._target.id() != 0; }
    /// Gives back the memory of those targets.
    void forget() { _drawn = {}, _resolve.forget(); }

    /// The same picture piece by piece and left on the GPU, so that an interactive caller can handle input
    /// between calls. `begin` draws the views that all pieces sample; the inputs stay the same until the last
    /// piece. `used`: a sketch that is shown no longer, whose targets serve again if they are of that size.
    Sketch begin(const Inputs& inputs, glm::ivec2 size, int perPixel, Sketch used);
    /// The pixels of `rows` (from the bottom; first, and one past the last).
    void drawRows(const Inputs& inputs, const Sketch& sketch, glm::ivec2 rows);

  private:
    void drawWhole(const Inputs& inputs, glm::ivec2 size);
    void fit(Sketch& sketch, glm::ivec2 size, int perPixel);
    void addGodrays(const Inputs& inputs, const Sketch& sketch);
    ReceiverPass::Inputs receiverInputs(const Inputs& inputs, const ViewFrameData& frame) const;
    void drawView(const ReceiverPass::Inputs& receivers, const gl::Framebuffer& target, Side side, Way way);

    gl::Context& _context;
    ReceiverPass _receivers;
    WaterPass _water;
    PictureResolve _resolve;
    std::optional<gl::Program> _godrays; ///< made for the first picture with some
    gl::VertexArray _noVertices;
    Sketch _drawn; ///< of the last picture, empty before the first
};

} // namespace limpid
