#pragma once
#include <vector>

#include "core/ShaderData.h"
#include "gl/Context.h"
#include "gl/Handles.h"
#include "gl/Program.h"
#include "godrays/GodrayTarget.h"

namespace limpid {

/// Shafts of light by a march through lit water. The water is cut by level planes into gaps; the rays of all
/// beams give each gap that they reach a layer of what they would scatter to the camera, by their own
/// direction; and each pixel sums along its view, with extinction both ways, what lies before what it sees.
/// As rays, gaps, cells and steps grow in number this is single scattering.
class ExactShafts {
  public:
    static bool does(GodrayMethod method) { return method == GodrayMethod::ExactShafts; }
    explicit ExactShafts(gl::Context& context);

    /// Adds to `target` the radiance that the water between the camera and what ends the view scatters to it.
    void draw(GodrayTarget& target, const GodrayInputs& inputs);

    /// How the water is cut for one light.
    struct Gaps {
        std::vector<gpu::Gap> gaps;
        int even = 0;        ///< so many from the top are of one height
        double height = 1;   ///< of those, m
        glm::ivec2 cells{1}; ///< of a layer
    };

  private:
    void light(const GodrayInputs& inputs, const GodraySource& source, const Gaps& gaps);
    void resolve(const Gaps& gaps, double steps);
    void march(const GodrayInputs& inputs, const GodraySource& source, const Gaps& gaps);
    gl::Context& _context;
    gl::Program _deposit, _resolve, _march;
    gl::Buffer _gaps, _sums;
    gl::Texture _lit;
    gl::VertexArray _noVertices;
};

/// The gaps for one light of `inputs`, their sums in at most `storageBytes`.
ExactShafts::Gaps shaftGaps(const GodrayInputs& inputs, const GodraySource& source,
                            std::int64_t storageBytes);

} // namespace limpid
