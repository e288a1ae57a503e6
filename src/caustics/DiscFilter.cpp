#include "caustics/DiscFilter.h"

#include <utility>

#include "gl/Bindings.h"
#include "plan/FlatWater.h"
#include "plan/SunDisc.h"

namespace limpid {

namespace {

constexpr glm::ivec2 groupSize{8, 8};

/// How the mean light below the surface turns as the sun moves from the middle of its disc to the rim of what
/// one point of it stands for. No unit.
glm::dvec3 turned(const Light& light, const Water& water, const glm::dvec2& towards) {
    const glm::dvec2 rim = discPointRadius * towards;
    return 0.5 * (refractedAt(beside(light, rim), water, {}) - refractedAt(beside(light, -rim), water, {}));
}

} // namespace

DiscFilter::DiscFilter(gl::Context& context) : _context(context), _filter({"caustics/disc_filter.comp"}) {}

void DiscFilter::apply(CausticMap& caustics, const Inputs& inputs) {
    const glm::dvec3 right = turned(inputs.light, inputs.water, {1, 0});
    const glm::dvec3 down = turned(inputs.light, inputs.water, {0, 1});
    // Narrower than the filter looks at. A side map's faces may be so steep that a narrow beam is wide
    // there.
    const double widest = inputs.farthest * std::max(glm::length(right), glm::length(down));
    if (inputs.map.facing == 0 && widest < 0.05 * inputs.map.frame.texel) return;
    const glm::ivec2 size = inputs.map.frame.size;
    _spread.resize(_context, size);
    inputs.beams.frame.bindUniform(lightFrameBlock);
    inputs.map.box.bindUniform(boxFrameBlock);
    caustics.irradiance.bind(irradianceMapUnit);
    inputs.map.position.bind(positionMapUnit);
    inputs.map.normal.bind(normalMapUnit);
    _spread.irradiance.bindImage(irradianceImage, GL_WRITE_ONLY);
    _filter.set(turnRightLocation, glm::vec3(right));
    _filter.set(turnDownLocation, glm::vec3(down));
    _filter.dispatch2D(size, groupSize);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    std::swap(caustics.irradiance, _spread.irradiance);
}

} // namespace limpid
