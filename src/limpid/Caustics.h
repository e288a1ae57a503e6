#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include <glm/glm.hpp>

#include "core/Error.h"
#include "core/Picture.h"
#include "limpid/Context.h"
#include "scene/HostMesh.h"
#include "scene/HostWater.h"
#include "scene/Scene.h"

/// Light through moving water, for a host with a renderer of its own. SI units, Y up, right-handed, linear
/// RGB.
namespace limpid {

/// Light of one source on one receiver, as textures that the host samples (limpid_caustics.glsl). They
/// belong to Caustics; their names hold until its next set(), update() or
/// render(). Row 0 is the top: u right, v down.
struct LitMap {
    int receiver = 0;             ///< index into Scene::receivers
    int light = 0;                ///< index into Scene::lights
    glm::ivec2 size{0};           ///< texels
    double texel = 0;             ///< m, the side of one
    double depth = 0;             ///< m along the light, of the box that the map covers
    std::uint32_t irradiance = 0; ///< RGBA32F: W/m² on the receiver's own surface; alpha has no meaning
    /// RG32F: m along the light from the box's near face; -1 where the texel shows no receiver, else another
    /// number.
    std::uint32_t position = 0;
    std::uint32_t normal = 0;    ///< RG16: geometric normal facing the light, octahedral
    glm::mat4 worldToTexture{1}; ///< from m relative to `origin` to [0, 1]³: u, v, and depth along the light
    glm::dvec3 origin{0};        ///< m in the world; 0 unless the scene is far from it
};

/// The caustics of a scene. Not thread-safe: all calls, the destructor's too, on the thread where the context
/// is current, or GraphicsError says so. The host's OpenGL state is the same after every call. After an
/// exception it stays of use.
class Caustics {
  public:
    /// Compiles no more than all methods share. Throws GraphicsError.
    explicit Caustics(const Context& context);
    ~Caustics();
    Caustics(Caustics&&) noexcept;
    Caustics& operator=(Caustics&&) noexcept;

    /// The scene from now on: another, or the same with any change, of which the next update() makes anew
    /// what depends on it and nothing else. Every receiver has a mesh, every number lies in the range that
    /// scene/Scene.h says. Throws InputError (place, expected, got) or GraphicsError, and then keeps the
    /// scene before. A host's buffers and textures are as their HostMesh and HostWater say.
    void set(Scene scene);
    const Scene& scene() const; ///< of the last set(), with its camera framed

    /// Computes the caustics under the water at `seconds`, any finite time of the scene. Throws InputError
    /// before set(), for a time that is not finite, a height map that cannot be loaded or a HostWater whose
    /// texture is not as it says; GraphicsError.
    void update(double seconds);
    /// One for each light and each receiver that reaches below the level; more for receivers with faces along
    /// the light. Light on a point is the sum over the maps of its receiver. Throws InputError unless
    /// update() came after the last set() and render().
    std::vector<LitMap> maps() const;
    /// The irradiance of one of maps(), by its number: RGB, W/m², rows from the top, 0 where there is
    /// no receiver. Waits for the GPU. Throws InputError as maps() does and for a number that none has.
    std::vector<float> irradiance(int map) const;

    /// The scene as its camera sees it at `seconds`; `size` in pixels, from 1 to what the GPU has. Computes
    /// those caustics alone that the picture shows. Waits for the GPU. Until the next update(), up to 350
    /// bytes a pixel stay on the GPU for another picture of that size. Throws as update() does, and
    /// InputError for a size out of range.
    Picture render(double seconds, glm::ivec2 size);

  private:
    struct Impl;
    std::unique_ptr<Impl> _impl;
};

// Where a host's GLM is set to other layouts (GLM_FORCE_DEFAULT_ALIGNED_GENTYPES), this library does not fit.
static_assert(sizeof(glm::dvec3) == 3 * sizeof(double) && sizeof(glm::mat4) == 16 * sizeof(float),
              "limpid: expected GLM without aligned types");

} // namespace limpid
