#pragma once
#include <array>
#include <memory>
#include <vector>

#include <glm/glm.hpp>

#include "gl/Context.h"
#include "gl/Handles.h"
#include "scene/Scene.h"
#include "water/HostHeights.h"
#include "water/SpectralWaves.h"

namespace limpid {

/// Which two frames a sequence shows, and how much of each. It runs in a loop: after the last frame comes the
/// first.
struct FramePair {
    int first = 0;
    int second = 0;   ///< the same as `first` where its share is 0
    double share = 0; ///< of `second`, [0, 1)
};
FramePair framesAt(int frameCount, double fps, double time);

/// One height map as shaders/water/surface.comp reads it.
struct HeightMapData {
    glm::vec4 place{0};  ///< corner x, z, m from the scene's origin; texels a metre along x and z
    glm::vec2 shares{0}; ///< m for one unit of the first frame and of the second
    bool tiled = false;  ///< repeats without end
};

/// The frames that are to be seen of each height map, as textures: coefficients of a B-spline (HeightField),
/// R32F, row 0 at the smallest z. A frame that is there from the call before is not loaded again. Spectra
/// come as height maps that are made anew for each time, and are tiled; a host's texture is read anew by each
/// `bind`.
class HeightMaps {
  public:
    explicit HeightMaps(gl::Context& context) : _context(context) {}

    /// Binds the frames of the i-th height map or spectrum of `water` at `time` (s) to texture units 2i and
    /// 2i + 1.
    std::vector<HeightMapData> bind(const Water& water, const glm::dvec3& origin, double time);

  private:
    struct Frame {
        std::shared_ptr<HeightSource> source;
        int index = -1;
        gl::Texture spline;
    };
    using Frames = std::array<Frame, 2>;

    /// The one of `frames` that holds frame `index`, after loading it in place of one other than `kept` if
    /// need be.
    const Frame& hold(Frames& frames, const std::shared_ptr<HeightSource>& source, int index, int kept);

    HeightMapData bindFrames(const Wave& wave, std::size_t number, const glm::dvec3& origin, double time);
    HeightMapData bindHost(const Wave& wave, std::size_t number, const glm::dvec3& origin);
    HeightMapData bindSpectrum(const Wave& wave, std::size_t number, const glm::dvec3& origin, double time);

    gl::Context& _context;
    std::array<Frames, maxHeightMaps> _frames;
    std::array<SpectralTile, maxHeightMaps> _tiles;
    std::array<gl::Texture, maxHeightMaps> _hostSplines;
    std::unique_ptr<SpectralWaves> _spectralWaves; ///< made for the first spectrum
    std::unique_ptr<HostHeights> _hostHeights;     ///< made for the first of a host's textures
};

} // namespace limpid
