#pragma once
#include <optional>

#include "apps/viewer/Projection.h"
#include "scene/Scene.h"

namespace limpid::viewer {

/// Of the mesh's bounds, in its own space.
glm::dvec3 meshMiddle(const Mesh& mesh);

/// How a receiver is moved by mouse: by handles in the scene, one for each axis, which are seen through the
/// water as it is. Arrows move it along the world's axes, rings turn it about them, and arms scale it along
/// its own.
struct Gizmo {
    enum class Mode { Move, Turn, Scale };
    static constexpr int axisCount = 3;

    Mode mode = Mode::Move;
    glm::dvec3 middle{0};     ///< world, m
    glm::dmat3 axes{1};       ///< columns, unit
    double size = 1;          ///< m, of a handle from the middle
    glm::bvec3 hidden{false}; ///< handles that point at the camera, where a mouse could not tell how far

    /// Handles of a receiver, `pixels` long; `middle` of its mesh, in its own space.
    Gizmo(const Receiver& receiver, const glm::dvec3& middle, Mode mode, const Projection& projection,
          double pixels);

    /// A handle's point in the world: `s` m from the middle, or at `s` radians on the ring.
    glm::dvec3 at(int axis, double s) const;
    /// The stretch of a handle that is drawn and can be grabbed.
    glm::dvec2 ends() const;
    /// The handle that `mouse` is within `reach` pixels of, the nearest.
    std::optional<int> under(const glm::dvec2& mouse, double reach, const Projection& projection) const;
    /// Where the line of a handle, followed from `s`, is nearest to `mouse`.
    double follow(int axis, double s, const glm::dvec2& mouse, const Projection& projection) const;
};

/// A handle in the hand: what was grabbed stays under the mouse, as far as its line leads there.
class GizmoDrag {
  public:
    GizmoDrag(const Receiver& receiver, const Gizmo& gizmo, int axis, const glm::dvec2& mouse,
              const Projection& projection);

    /// The receiver with the mouse there. `alike`: scaled along all axes as along this one.
    const Receiver& to(const glm::dvec2& mouse, const Projection& projection, bool alike = false);
    int axis() const { return _axis; }

  private:
    void move(double way);
    void turn(double angle);
    void scale(double factor, bool alike);

    Receiver _start, _now;
    Gizmo _gizmo;
    int _axis;
    double _grabbed, _at; ///< places on the handle's line
};

} // namespace limpid::viewer
