#pragma once
#include <vector>

#include "scene/Scene.h"

namespace limpid::viewer {

/// What was done to a scene, to be taken back step by step. The camera is let alone: who looks around has
/// changed nothing.
class History {
  public:
    /// Forgets all; `scene` is where it begins.
    void begin(const Scene& scene);
    /// Sees how the scene is now. `held`: something is in the hand still, and the step goes on.
    void follow(const Scene& scene, bool held);
    /// Each returns whether there was a step.
    bool undo(Scene& scene);
    bool redo(Scene& scene);

  private:
    static bool move(std::vector<Scene>& from, std::vector<Scene>& to, Scene& known, Scene& scene);

    Scene _known; ///< after the last step
    std::vector<Scene> _past, _future;
};

} // namespace limpid::viewer
