#include "apps/viewer/History.h"

#include <utility>

namespace limpid::viewer {

namespace {

constexpr std::size_t mostSteps = 200;

bool sameButCamera(Scene a, const Scene& b) {
    a.camera = b.camera;
    return a == b;
}

} // namespace

void History::begin(const Scene& scene) {
    _known = scene;
    _past.clear();
    _future.clear();
}

void History::follow(const Scene& scene, bool held) {
    if (held || sameButCamera(scene, _known)) return;
    _past.push_back(std::exchange(_known, scene));
    if (_past.size() > mostSteps) _past.erase(_past.begin());
    _future.clear();
}

bool History::move(std::vector<Scene>& from, std::vector<Scene>& to, Scene& known, Scene& scene) {
    if (from.empty()) return false;
    to.push_back(std::exchange(known, std::move(from.back())));
    from.pop_back();
    const Camera camera = scene.camera;
    scene = known;
    scene.camera = camera;
    return true;
}

bool History::undo(Scene& scene) {
    follow(scene, false);
    return move(_past, _future, _known, scene);
}

bool History::redo(Scene& scene) {
    return move(_future, _past, _known, scene);
}

} // namespace limpid::viewer
