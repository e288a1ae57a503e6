#pragma once
#include "gl/Context.h"
#include "gl/Handles.h"
#include "gl/Program.h"
#include "levelmap/LevelMap.h"
#include "occlusion/Occluders.h"

namespace limpid {

/// Shares of the light on a receiver by what light goes through: what its own translucent surface takes, and
/// for methods that shade by the mean light, what sheets before it leave. RGBA16 in the frame of a level map,
/// [0, 1] by channel.
class TakenLight {
  public:
    explicit TakenLight(gl::Context& context);

    /// 1 - transmittance (scene/Mesh.h) of what a drawn level map shows; 1 for a receiver that is opaque.
    gl::Texture opacity(const LevelMap& map, const LitReceiver& receiver);
    /// Times what is left of the mean light behind the sheets before each texel.
    void shade(const gl::Texture& share, const LevelMap& map, const LitReceiver& receiver,
               const Occluders& occluders);
    /// Times `irradiance`, RGBA32F in the map's frame.
    void apply(const gl::Texture& irradiance, const gl::Texture& share) const;

  private:
    gl::Context& _context;
    gl::Program _opacity, _shade, _apply;
};

} // namespace limpid
