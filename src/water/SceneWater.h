#pragma once
#include "core/Kept.h"
#include "gl/TimerQuery.h"
#include "water/WaterSurface.h"

namespace limpid {

/// A scene's water. Its surface is brought to a time when somebody asks for it there, and not before.
class SceneWater {
  public:
    SceneWater(gl::Context& context, gl::PassTimers& timers, Making& making)
        : _timers(timers), _making(making), _surface(context) {}

    /// `patch` in the world; `origin`: what positions on the GPU are relative to, m.
    void set(const Water& water, const WaterPatch& patch, const glm::dvec3& origin);

    /// Names a surface: two that are equal have equal names.
    struct Moment {
        Stamp shape = 0;
        double time = 0; ///< s; 0 where nothing moves
        Stamp read = 0;  ///< when a host's heights were read; 0 without such
        bool operator==(const Moment&) const = default;
    };
    Moment moment(double time) const;
    /// From here on a host's texture (scene/HostWater.h) counts as it now is, until the next call.
    void readHosts();
    /// The surface at `time` (s). Throws InputError if a height map's frame cannot be loaded.
    const WaterMesh& at(double time);
    /// As it was last asked for.
    const WaterMesh& mesh() const { return _surface.mesh(); }
    /// It is made anew when it is next asked for.
    void forget() { _shown.forget(); }

  private:
    /// What of the water is in its shape.
    struct Shape {
        Water water;
        WaterPatch patch;
        glm::dvec3 origin{0};
        bool operator==(const Shape&) const = default;
    };
    gl::PassTimers& _timers;
    Making& _making;
    WaterSurface _surface;
    Shape _shape;
    Stamp _shapeStamp = 0;
    bool _moves = false;
    Stamp _read = 0;
    Kept<Moment> _shown;
};

} // namespace limpid
