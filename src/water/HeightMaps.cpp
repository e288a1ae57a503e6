#include "water/HeightMaps.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/Error.h"
#include "gl/Bindings.h"

namespace limpid {

namespace {

HeightMapData heightMapData(const Wave& wave, const glm::dvec3& origin, double share) {
    const glm::dvec2 corner = wave.center - 0.5 * wave.size - glm::dvec2(origin.x, origin.z);
    const glm::dvec2 texels = glm::dvec2(wave.heights->bounds().size) / wave.size;
    return {glm::vec4(corner, texels), glm::vec2(wave.amplitude * (1 - share), wave.amplitude * share),
            false};
}

} // namespace

FramePair framesAt(int frameCount, double fps, double time) {
    double at = std::fmod(time * fps, double(frameCount));
    if (at < 0) at += frameCount;
    // 0.1 s at 30 frames a second is frame 3, whatever the rounding of 0.1.
    if (const double whole = std::round(at); std::abs(at - whole) < 1e-6) at = whole;
    const double first = std::floor(at);
    FramePair pair;
    pair.first = int(first) % frameCount;
    pair.share = frameCount > 1 ? at - first : 0;
    pair.second = pair.share > 0 ? (pair.first + 1) % frameCount : pair.first;
    return pair;
}

const HeightMaps::Frame& HeightMaps::hold(Frames& frames, const std::shared_ptr<HeightSource>& source,
                                          int index, int kept) {
    for (const Frame& frame : frames)
        if (frame.source == source && frame.index == index) return frame;
    Frame& frame = frames[0].source == source && frames[0].index == kept ? frames[1] : frames[0];
    const std::shared_ptr<const HeightField> field = source->frame(index);
    frame.index = -1;
    if (frame.spline.size() != field->size)
        frame.spline = gl::Texture(_context.ledger(), "height map", GL_R32F, field->size);
    frame.spline.upload(GL_RED, GL_FLOAT, field->spline.data());
    frame.source = source;
    frame.index = index;
    return frame;
}

HeightMapData HeightMaps::bindFrames(const Wave& wave, std::size_t number, const glm::dvec3& origin,
                                     double time) {
    const FramePair pair = framesAt(wave.heights->frameCount(), wave.fps, time);
    Frames& frames = _frames[number];
    const auto unit = GLuint(heightFramesUnit + 2 * int(number));
    hold(frames, wave.heights, pair.first, pair.second).spline.bind(unit);
    hold(frames, wave.heights, pair.second, pair.first).spline.bind(unit + 1);
    _tiles[number] = {};
    _hostSplines[number] = {};
    return heightMapData(wave, origin, pair.share);
}

HeightMapData HeightMaps::bindHost(const Wave& wave, std::size_t number, const glm::dvec3& origin) {
    if (!_hostHeights) _hostHeights = std::make_unique<HostHeights>(_context);
    _hostHeights->update(_hostSplines[number], *wave.heights);
    _hostSplines[number].bind(GLuint(heightFramesUnit + 2 * int(number)));
    _hostSplines[number].bind(GLuint(heightFramesUnit + 2 * int(number) + 1));
    _frames[number] = {};
    _tiles[number] = {};
    return heightMapData(wave, origin, 0);
}

HeightMapData HeightMaps::bindSpectrum(const Wave& wave, std::size_t number, const glm::dvec3& origin,
                                       double time) {
    if (!_spectralWaves) _spectralWaves = std::make_unique<SpectralWaves>(_context);
    SpectralTile& tile = _tiles[number];
    _spectralWaves->update(tile, wave.spectrum, time);
    tile.heights.bind(GLuint(heightFramesUnit + 2 * int(number)));
    tile.heights.bind(GLuint(heightFramesUnit + 2 * int(number) + 1));
    _frames[number] = {};
    _hostSplines[number] = {};
    // Texel 0 is at the world's origin; how far that is from the scene's is told within one tile.
    const glm::dvec2 texels = double(tile.heights.size().x) / wave.spectrum->tile;
    const glm::dvec2 away = glm::mod(glm::dvec2(origin.x, origin.z), wave.spectrum->tile);
    return {glm::vec4(-away - 0.5 / texels, texels), glm::vec2(wave.amplitude, 0), true};
}

std::vector<HeightMapData> HeightMaps::bind(const Water& water, const glm::dvec3& origin, double time) {
    std::vector<HeightMapData> maps;
    for (const Wave& wave : water.waves) {
        if (!isTexture(wave.type)) continue;
        if (maps.size() == _frames.size())
            throw InputError(fmt::format(
                "water.wave: expected at most {} height maps and spectra, found more", _frames.size()));
        if (wave.type == WaveType::Phillips)
            maps.push_back(bindSpectrum(wave, maps.size(), origin, time));
        else if (wave.heights->texture() != 0)
            maps.push_back(bindHost(wave, maps.size(), origin));
        else
            maps.push_back(bindFrames(wave, maps.size(), origin, time));
    }
    for (std::size_t i = maps.size(); i < _frames.size(); ++i) {
        _frames[i] = {};
        _tiles[i] = {};
        _hostSplines[i] = {};
    }
    return maps;
}

} // namespace limpid
