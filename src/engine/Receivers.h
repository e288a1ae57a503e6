#pragma once
#include <memory>
#include <span>
#include <vector>

#include "core/Kept.h"
#include "gl/TimerQuery.h"
#include "levelmap/ReceiverGeometry.h"
#include "occlusion/Occluders.h"

namespace limpid {

/// A scene's receivers on the GPU, each with when it was made.
class Receivers {
  public:
    explicit Receivers(gl::Context& context) : _context(context) {}

    /// Those that look and stand as the one of their number before are not made again, and of those that only
    /// stand elsewhere no more than their vertices. `origin`: what
    /// positions on the GPU are relative to, m. Throws GraphicsError, and then keeps those before.
    void set(std::span<const Receiver> receivers, const glm::dvec3& origin);

    std::span<const ReceiverGeometry> all() const { return _geometries; }
    const ReceiverGeometry& at(int number) const { return _geometries[std::size_t(number)]; }
    Stamp stamp(int number) const { return _stamps[std::size_t(number)]; }
    const std::vector<Stamp>& stamps() const { return _stamps; }
    std::vector<Stamp> stampsOf(std::span<const int> numbers) const;
    /// Whether any lets some light through.
    bool translucent() const { return _translucent; }

    /// All of them as things in light's way; made when they are asked for.
    const Occluders& occluders(gl::PassTimers& timers);
    void freeOccluders() { _occluders.reset(), _occludersOf.forget(); }

  private:
    gl::Context& _context;
    Making _making; ///< its own: what does not move is not made anew by anybody who measures what does
    std::vector<Receiver> _receivers;
    glm::dvec3 _origin{0};
    std::vector<ReceiverGeometry> _geometries;
    std::vector<Stamp> _stamps;
    bool _translucent = false; ///< asked for each map, which may be as many as these
    std::unique_ptr<Occluders> _occluders;
    Kept<std::vector<Stamp>> _occludersOf;
};

} // namespace limpid
