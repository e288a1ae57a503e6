#pragma once
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "apps/viewer/Display.h"
#include "apps/viewer/Ladder.h"
#include "engine/Engine.h"

namespace limpid::viewer {

/// What the window is to show.
struct Wanted {
    Scene scene;
    double time = 0;             ///< s
    glm::ivec2 size{0};          ///< pixels of the picture
    std::optional<Method> other; ///< a second method to compare with

    bool operator==(const Wanted&) const = default;
};

/// Makes pictures of a scene that changes: at once, with as little work as the machine needs to keep up, and
/// then, while all rests, again and again with more until it is the picture of `limpid render`. It works in
/// pieces, so that in between somebody can ask for something else.
class Stage {
  public:
    /// `skipping`: work may be left out that changes nothing (Engine::setSkipping).
    Stage(gl::Context& context, bool skipping);

    /// Throws InputError for a scene that cannot be, and then keeps the one before.
    void want(const Wanted& wanted);
    void setShown(const Shown& shown);

    /// The next piece. Returns whether there is another picture to be seen. Throws InputError when a wave's
    /// image cannot be loaded.
    bool work();
    /// Whether the picture is all that it can be.
    bool rests() const { return _state == State::Rests; }
    /// Whether a better picture is under way; it does not rest, nor wait for rest.
    bool refines() const { return !_refining.empty(); }
    /// Goes on to that without a pause for what may move next.
    void hurry() { _lastChange = {}; }
    /// Makes everything anew: after shaders changed. Throws GraphicsError if they do not compile; then it
    /// goes on as before.
    void reloadShaders();

    /// Once there is one: the picture, as large as `resolution` says of what was asked for.
    const Display* display() const { return _sketches.empty() ? nullptr : _display.get(); }
    double resolution() const;
    bool fullMaps() const { return _mapStep == 0; }
    /// Of the first method; it may work with coarser settings than the scene's while something moves.
    Engine& engine() { return *_engines.front(); }
    bool hasScene() const { return _hasScene; }
    /// GPU time of each pass in the last piece of work that made a picture, ms.
    const std::vector<std::pair<std::string, double>>& passes() const { return _passes; }
    /// Counts pictures that were made at once, and those made after, better.
    int answers() const { return _answers; }

  private:
    using Clock = std::chrono::steady_clock;
    enum class State { Changed, Waits, Rests };
    std::unique_ptr<Engine> newEngine() const;
    Scene sceneOf(std::size_t engine, std::size_t step) const;
    bool nextPiece();
    void makeMaps(std::size_t step);
    void drawAtOnce();
    bool refine();
    double drawRows(glm::ivec2 rows); ///< of what is refined; ms
    void beginRefining(std::size_t step);
    void showSketches();
    void collectPasses();

    gl::Context& _context;
    bool _skipping;
    std::vector<std::unique_ptr<Engine>> _engines; ///< one for each method that is shown
    std::unique_ptr<Display> _display;
    Shown _shown;
    Wanted _wanted;
    State _state = State::Rests;
    bool _hasScene = false, _lightChanged = false;
    Ladder _mapLadder, _pictureLadder;
    std::size_t _mapStep = 0, _pictureStep = 0; ///< of what is shown
    std::size_t _refiningStep = 0;
    int _rowsDone = 0;
    double _pieceMs = 0, _rowMs = 0; ///< of what is refined: any piece of it, and then each row
    Clock::time_point _lastChange;
    std::vector<PicturePass::Sketch> _sketches, _refining; ///< one for each engine
    std::vector<std::pair<std::string, double>> _passes;
    int _answers = 0;
};

} // namespace limpid::viewer
