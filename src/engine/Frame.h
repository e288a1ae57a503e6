#pragma once
#include "core/Kept.h"
#include "core/Skipped.h"
#include "engine/Receivers.h"
#include "gl/Context.h"
#include "gl/TimerQuery.h"
#include "plan/Plan.h"
#include "scene/MethodFacts.h"
#include "water/SceneWater.h"

namespace limpid {

/// What the parts of a frame are made from and with.
struct Frame {
    gl::Context& context;
    gl::PassTimers& timers;
    Making& making;
    Skipped& skipped;
    const Scene& scene;
    const Plan& plan;
    Receivers& receivers;
    SceneWater& water;
    double time;   ///< of the caustics, s
    bool skipping; ///< work may be left out that changes nothing

    const Light& light(int index) const { return scene.lights[std::size_t(index)]; }
    const PlannedLight& planOf(int light) const { return plan.lights[std::size_t(light)]; }
    const MethodFacts& facts() const { return factsOf(scene.caustics.method); }
};

} // namespace limpid
