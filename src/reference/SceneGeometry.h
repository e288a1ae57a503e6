#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include <embree3/rtcore.h>
#include <glm/glm.hpp>

#include "reference/FaceSorting.h"
#include "scene/Scene.h"

namespace limpid::reference {

/// The most faces that light is followed through: the last takes what is left.
inline constexpr int mostSheets = 32;

/// Where a ray meets a face.
struct Hit {
    int receiver = -1; ///< -1: it passes every receiver
    double distance = 0;
    glm::dvec3 point{0};         ///< m from the origin
    glm::dvec3 normal{0};        ///< unit, of the face, by the winding
    glm::dvec3 transmittance{0}; ///< share of light that goes on behind it (scene/Mesh.h)
    bool shown = true;           ///< by maps (scene/Mesh.h, shownAlpha)
    double reach = 0;            ///< distance as Embree has it

    explicit operator bool() const { return receiver >= 0; }
};

/// All receivers as Embree sees them. Faces take light on both sides; where one lets all of it through there
/// is a hole. Embree finds the face in single precision, relative to the middle of the receivers; the place
/// on it is then had in double. May be asked by many threads at once.
class SceneGeometry {
  public:
    /// Places are relative to `origin` (m, in the world). Throws std::runtime_error if Embree fails.
    SceneGeometry(const Scene& scene, const glm::dvec3& origin);
    ~SceneGeometry();
    SceneGeometry(const SceneGeometry&) = delete;
    SceneGeometry& operator=(const SceneGeometry&) = delete;

    /// The first face along the ray. `direction` unit.
    Hit first(const glm::dvec3& from, const glm::dvec3& direction) const;
    /// The first one beyond a hit of the same ray.
    Hit next(const glm::dvec3& from, const glm::dvec3& direction, const Hit& passed) const;
    /// Share of light that the faces within `distance` m let through.
    glm::dvec3 through(const glm::dvec3& from, const glm::dvec3& direction, double distance) const;
    /// Whether any face lies within `distance` m.
    bool blocked(const glm::dvec3& from, const glm::dvec3& direction, double distance) const;
    /// The first face of one receiver, below `level` (y), that map `facing` shows.
    Hit firstShown(int receiver, const glm::dvec3& from, const glm::dvec3& direction, double level,
                   const FaceSorting& faces, int facing) const;

    /// The highest y of any receiver, m from the origin.
    double top() const { return _top; }

  private:
    struct Shape;
    struct ShownContext;

    void addReceiver(const Receiver& receiver, const glm::dvec3& origin);
    RTCRayHit ray(const glm::dvec3& from, const glm::dvec3& direction) const;
    Hit refined(const Shape& shape, int receiver, const RTCRayHit& query, const glm::dvec3& from,
                const glm::dvec3& direction) const;
    Hit nearest(RTCRayHit& query, const glm::dvec3& from, const glm::dvec3& direction) const;
    static void filterHoles(const RTCFilterFunctionNArguments* arguments);
    static void filterShown(const RTCFilterFunctionNArguments* arguments);

    RTCDevice _device = nullptr;
    RTCScene _all = nullptr;
    std::vector<std::unique_ptr<Shape>> _shapes;
    glm::dvec3 _middle{0}; ///< what Embree's places are relative to, m from the origin
    double _top = -1e300;
    bool _translucent = false; ///< some face lets light through
};

} // namespace limpid::reference
