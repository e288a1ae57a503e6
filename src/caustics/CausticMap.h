#pragma once
#include <glm/glm.hpp>

#include "gl/Context.h"
#include "gl/Handles.h"

namespace limpid {

/// Irradiance on a receiver from one light. RGBA32F, W/m² on the receiver's own surface, mean over the texel;
/// alpha has no meaning. Frame and rows are those of the receiver's level map.
struct CausticMap {
    gl::Texture irradiance;

    void resize(gl::Context& context, glm::ivec2 size) {
        if (irradiance.id() && irradiance.size() == size) return;
        irradiance = gl::Texture(context.ledger(), "caustic map", GL_RGBA32F, size);
    }
    /// No light.
    void clear(gl::Context& context, glm::ivec2 size) {
        resize(context, size);
        glClearTexImage(irradiance.id(), 0, GL_RGBA, GL_FLOAT, nullptr);
    }
};

/// Which colours a method in integers sums: those that may differ (in grey water one stands for all), or each
/// by itself. The maps are the same.
enum class Colours { AsNeeded, All };

} // namespace limpid
