#include "water/HeightMaps.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/Error.h"

namespace limpid {

namespace {

HeightMapData heightMapData(const Wave& wave, const glm::dvec3& origin, double share) {
    const glm::dvec2 corner = wave.center - 0.5 * wave.size - glm::dvec2(origin.x, origin.z);
    const glm::dvec2 texels = glm::dvec2(wave.heights->bounds().size) / wave.size;
    return {glm::vec4(corner, texels), glm::vec2(wave.amplitude * (1 - share), wave.amplitude * share)};
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

std::vector<HeightMapData> HeightMaps::bind(const Water& water, const glm::dvec3& origin, double time) {
    std::vector<HeightMapData> maps;
    for (const Wave& wave : water.waves) {
        if (wave.type != WaveType::HeightMap) continue;
        if (maps.size() == _frames.size())
            throw InputError(
                fmt::format("water.wave: expected at most {} height maps, found more", _frames.size()));
        const FramePair pair = framesAt(wave.heights->frameCount(), wave.fps, time);
        Frames& frames = _frames[maps.size()];
        const auto unit = GLuint(2 * maps.size());
        hold(frames, wave.heights, pair.first, pair.second).spline.bind(unit);
        hold(frames, wave.heights, pair.second, pair.first).spline.bind(unit + 1);
        maps.push_back(heightMapData(wave, origin, pair.share));
    }
    for (std::size_t i = maps.size(); i < _frames.size(); ++i)
        _frames[i] = {};
    return maps;
}

} // namespace limpid
