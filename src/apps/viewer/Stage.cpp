#include "apps/viewer/Stage.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "gl/Api.h"

namespace limpid::viewer {

namespace {

using Ms = std::chrono::duration<double, std::milli>;

/// While something moves: what a picture and what new caustics may take, and how long it must have rested
/// before the picture, and then the caustics, are made better.
constexpr double pictureTarget = 55, mapsTarget = 90, piece = 45; // ms
constexpr Ms pictureRest{200}, mapsRest{350};

/// Resolution, as a share, and samples along each axis of a pixel.
struct PictureWork {
    double scale;
    int perPixel;
};
constexpr PictureWork pictureWork[] = {{1, 2}, {1, 1}, {0.75, 1}, {0.5, 1}, {0.375, 1}, {0.25, 1}, {0.18, 1}};

/// What maps and the water's grid are divided by.
struct MapReduction {
    int map, grid;
};
constexpr MapReduction mapReductions[] = {{1, 1}, {2, 1}, {2, 2}, {4, 2}, {8, 4}};

Ladder pictureLadder() {
    std::vector<double> shares;
    for (const PictureWork& work : pictureWork)
        shares.push_back(0.25 * std::pow(work.scale * work.perPixel, 2));
    return Ladder(shares);
}

/// As measured with the default scene of a model in exact beams on a software driver.
Ladder mapLadder() {
    return Ladder({1, 0.45, 0.3, 0.12, 0.05});
}

Scene reduced(Scene scene, std::size_t step) {
    const MapReduction& work = mapReductions[step];
    scene.caustics.mapSize =
        std::max(scene.caustics.mapSize / work.map, std::min(scene.caustics.mapSize, 32));
    scene.water.grid = glm::max(scene.water.grid / work.grid, glm::min(scene.water.grid, glm::ivec2(32)));
    return scene;
}

bool sameLight(Scene a, const Scene& b) {
    a.camera = b.camera;
    a.skyRadiance = b.skyRadiance;
    a.ambientRadiance = b.ambientRadiance;
    a.godrays = b.godrays;
    return a == b;
}

glm::ivec2 sizeAt(glm::ivec2 size, std::size_t step) {
    return glm::max(glm::ivec2(glm::round(pictureWork[step].scale * glm::dvec2(size))), 1);
}

} // namespace

std::unique_ptr<Engine> Stage::newEngine() const {
    auto engine = std::make_unique<Engine>(_context);
    engine->setSkipping(_skipping);
    return engine;
}

Stage::Stage(gl::Context& context, bool skipping)
    : _context(context), _skipping(skipping), _display(std::make_unique<Display>(context)),
      _mapLadder(mapLadder()), _pictureLadder(pictureLadder()) {
    _engines.push_back(newEngine());
}

void Stage::want(const Wanted& wanted) {
    if (_hasScene && wanted == _wanted) return;
    const bool sameScene =
        _hasScene && wanted.other == _wanted.other && sameLight(_wanted.scene, wanted.scene);
    if (!sameScene) Engine::requireScene(wanted.scene, _context);
    _lightChanged = _lightChanged || !sameScene || wanted.time != _wanted.time;
    _wanted = wanted;
    _hasScene = true;
    _state = State::Changed;
    _refining.clear();
}

void Stage::setShown(const Shown& shown) {
    if (shown == _shown) return;
    _shown = shown;
    if (!_sketches.empty()) showSketches();
}

void Stage::showSketches() {
    _display->show(_sketches.front(), _sketches.size() > 1 ? &_sketches[1] : nullptr, _shown);
}

double Stage::resolution() const {
    return pictureWork[_pictureStep].scale;
}

/// What the engine of that number shows, with `step` of the map ladder.
Scene Stage::sceneOf(std::size_t engine, std::size_t step) const {
    Scene scene = reduced(_wanted.scene, step);
    if (engine == 1) scene.caustics.method = *_wanted.other;
    return scene;
}

/// Caustics of what is wanted, with `step` of the map ladder.
void Stage::makeMaps(std::size_t step) {
    const auto begin = Clock::now();
    const std::size_t count = _wanted.other ? 2 : 1;
    while (_engines.size() < count)
        _engines.push_back(newEngine());
    _engines.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        _engines[i]->set(sceneOf(i, step));
        _engines[i]->updateForPictures(_wanted.time);
    }
    _lightChanged = false;
    _mapStep = step;
    glFinish();
    _mapLadder.measured(step, Ms(Clock::now() - begin).count(), mapsTarget);
}

void Stage::drawAtOnce() {
    const std::size_t step = _pictureLadder.step();
    const auto begin = Clock::now();
    const glm::ivec2 size = sizeAt(_wanted.size, step);
    _sketches.clear();
    for (std::size_t i = 0; i < _engines.size(); ++i) {
        Engine& engine = *_engines[i];
        engine.set(sceneOf(i, _mapStep));
        _sketches.push_back(engine.beginPicture(size, pictureWork[step].perPixel));
        engine.drawRows(_sketches.back(), {0, size.y});
    }
    showSketches();
    glFinish();
    _pictureStep = step;
    _pictureLadder.measured(step, Ms(Clock::now() - begin).count(), pictureTarget);
}

void Stage::beginRefining(std::size_t step) {
    _refining.clear();
    for (const auto& engine : _engines)
        _refining.push_back(engine->beginPicture(sizeAt(_wanted.size, step), pictureWork[step].perPixel));
    _refiningStep = step;
    _rowsDone = 0;
    _rowMs = 0;
    glFinish();
    _pieceMs = drawRows({0, 0});
}

double Stage::drawRows(glm::ivec2 rows) {
    const auto begin = Clock::now();
    for (std::size_t i = 0; i < _engines.size(); ++i)
        _engines[i]->drawRows(_refining[i], rows);
    glFinish();
    return Ms(Clock::now() - begin).count();
}

/// Some more rows of a better picture; shows it once it is whole.
bool Stage::refine() {
    if (_refining.empty()) {
        beginRefining(_pictureStep > 1 ? 1 : 0);
        return false;
    }
    const int height = sizeAt(_wanted.size, _refiningStep).y;
    // What a piece costs of itself is a third of it at most.
    const double most = std::max(piece, 2 * _pieceMs);
    const int rows = _rowMs > 0 ? std::clamp(int(most / _rowMs), height / 64 + 1, height) : height / 16 + 1;
    const int end = std::min(_rowsDone + rows, height);
    const double ms = drawRows({_rowsDone, end});
    _rowMs = std::max(ms - _pieceMs, 0.1 * ms) / (end - _rowsDone);
    _rowsDone = end;
    if (end < height) return false;
    _sketches = std::exchange(_refining, {});
    _pictureStep = _refiningStep;
    showSketches();
    return true;
}

void Stage::collectPasses() {
    _passes = _engines.front()->timers().collect();
    for (std::size_t i = 1; i < _engines.size(); ++i)
        _engines[i]->timers().collect();
}

bool Stage::work() {
    if (_state == State::Rests || !_hasScene || _wanted.size.x < 1 || _wanted.size.y < 1) return false;
    try {
        return nextPiece();
    } catch (...) {
        _state = State::Rests; // or it would fail again and again
        throw;
    }
}

bool Stage::nextPiece() {
    if (_state == State::Changed) {
        _state = State::Waits;
        if (_lightChanged) makeMaps(_mapLadder.step());
        drawAtOnce();
        collectPasses();
        _lastChange = Clock::now();
        ++_answers;
        return true;
    }
    const Ms rested = Clock::now() - _lastChange;
    if (_mapStep > 0) {
        if (rested < mapsRest) return false;
        makeMaps(0);
        drawAtOnce();
        collectPasses();
        return true;
    }
    if (_pictureStep == 0) {
        _state = State::Rests;
        return false;
    }
    if (rested < pictureRest) return false;
    const bool finished = refine();
    if (finished) collectPasses();
    return finished;
}

void Stage::reloadShaders() {
    std::vector<std::unique_ptr<Engine>> engines;
    engines.push_back(newEngine());
    auto display = std::make_unique<Display>(_context);
    _sketches.clear();
    _refining.clear();
    _engines = std::move(engines);
    _display = std::move(display);
    _lightChanged = true;
    if (_hasScene) _state = State::Changed;
}

} // namespace limpid::viewer
