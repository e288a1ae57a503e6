#include "apps/viewer/Viewer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <imgui.h>

#include "apps/viewer/CameraControl.h"
#include "apps/viewer/ComparePanel.h"
#include "apps/viewer/GizmoOverlay.h"
#include "apps/viewer/History.h"
#include "apps/viewer/Interface.h"
#include "apps/viewer/Saving.h"
#include "apps/viewer/ShaderWatch.h"
#include "apps/viewer/Window.h"
#include "core/Error.h"
#include "core/Statistics.h"
#include "gl/Reset.h"
#include "io/images/Images.h"
#include "plan/Framing.h"
#include "plan/Warnings.h"

namespace limpid::viewer {

namespace {

using Clock = std::chrono::steady_clock;
using Ms = std::chrono::duration<double, std::milli>;

constexpr double framesPerSecond = 30; ///< of what `,` and `.` step through

Window::Options windowOptions(const Options& options) {
    Window::Options window{options.size, options.interfaceScale};
#ifndef NDEBUG
    window.debug = true;
#endif
    return window;
}

gl::ContextOptions contextOptions(const Options& options) {
    gl::ContextOptions context;
    context.memory = options.gpuMemory;
#ifndef NDEBUG
    context.debug = true;
#endif
    return context;
}

State::Side sideNamed(const std::string& name) {
    if (name == "measure") return State::Side::Measure;
    if (name == "understand") return State::Side::Understand;
    if (name == "compare") return State::Side::Compare;
    return State::Side::None;
}

/// The window and all that it shows.
class Viewer {
  public:
    explicit Viewer(const Options& options)
        : _options(options), _window(windowOptions(options)),
          _context(gl::Context::Current{}, contextOptions(options)), _stage(_context, !options.noSkip) {
        _state.time = options.time;
        _state.playing = options.play;
        _state.side = sideNamed(options.panel);
        _state.other = options.compare;
        if (_state.other) _state.shown.mode = Shown::Mode::Split;
    }

    void run() {
        if (!_options.file.empty()) load(_options.file, _options.load);
        select(_options.select);
        while (!_window.closes() && !_state.leave && !_done)
            frame();
        if (_options.verbose) report();
    }

  private:
    void load(const std::filesystem::path& file, const std::function<io::SceneDocument()>& read);
    void select(const std::string& name);
    void frame();
    double waitingTime() const;
    void doRequests();
    void saveWhatIsAsked();
    void reloadShaders();
    void advanceTime(double seconds);
    void makePicture(const Layout& layout);
    void frameSelection();
    void looked(Clock::time_point taken);
    void takeScreenshot();
    void fail(const std::exception& error);
    void report() const;

    const Options& _options;
    Window _window;
    gl::Context _context;
    Stage _stage;
    Understanding _understanding{_context};
    std::optional<io::SceneDocument> _document;
    std::optional<Recorder> _recorder;
    History _history;
    State _state;
    Measured _measured;
    Clock::time_point _last = Clock::now();
    ShaderWatch _shaders;
    Scene _before; ///< what the last frame showed
    int _lively = 0;
    bool _better = false, _worked = false, _done = false, _rested = false;
    int _completeFrames = 0;
};

void Viewer::fail(const std::exception& error) {
    _state.message = error.what();
    _state.playing = false;
}

void Viewer::load(const std::filesystem::path& file, const std::function<io::SceneDocument()>& read) {
    try {
        io::SceneDocument document = read();
        Scene scene = document.scene();
        scene.camera = framedCamera(scene);
        Engine::requireScene(scene, _context);
        _document = std::move(document);
        _recorder.reset();
        _state.recording = false;
        _state.loaded = scene;
        _state.scene = std::move(scene);
        _state.extent = std::max(glm::length(worldBounds(_state.scene).size()), 1e-6);
        _state.middles.clear();
        for (const Receiver& receiver : _state.scene.receivers)
            _state.middles.push_back(meshMiddle(*receiver.mesh));
        _history.begin(_state.scene);
        _state.file = file;
        _state.selected.reset();
        _state.drag.reset();
        _state.light = 0;
        _state.message.clear();
        _state.notice.clear();
        _window.setTitle(file.filename().string() + " – Limpid");
        const auto warnings = sceneWarnings(_state.scene, coveringPatch(_state.scene));
        if (!warnings.empty()) _state.message = fmt::format("{}", fmt::join(warnings, "\n"));
    } catch (const std::exception& error) {
        fail(error);
    }
}

void Viewer::select(const std::string& name) {
    if (name.empty() || !_state.hasScene()) return;
    const auto& receivers = _state.scene.receivers;
    for (std::size_t i = 0; i < receivers.size(); ++i)
        if (receivers[i].name == name) _state.selected = int(i);
    if (!_state.selected)
        _state.message = fmt::format("--select: expected the name of a receiver, found \"{}\"", name);
}

/// How long events may be waited for.
double Viewer::waitingTime() const {
    if (_window.hidden()) return 0.5;
    if (_lively > 0 || _worked || _state.playing || _recorder || !_options.screenshot.empty()) return 0;
    return _stage.rests() || !_state.hasScene() ? 0.5 : 0.02;
}

void Viewer::frameSelection() {
    Bounds bounds;
    if (_state.selected) bounds = worldBounds(_state.scene.receivers[std::size_t(*_state.selected)]);
    if (!_state.selected) bounds = worldBounds(_state.scene);
    viewer::frame(_state.scene.camera, bounds, _state.scene.water);
}

void Viewer::doRequests() {
    if (const std::string file = std::exchange(_state.open, ""); !file.empty())
        load(file, [&] { return io::SceneDocument(file); });
    for (const auto& file : _window.takeDropped())
        load(file, [&] { return io::SceneDocument(file); });
    if (std::exchange(_state.frameSelection, false)) frameSelection();
    if (std::exchange(_state.resetCamera, false)) {
        const double exposure = _state.scene.camera.exposure;
        _state.scene.camera = _state.loaded.camera;
        _state.scene.camera.exposure = exposure;
    }
    if (std::exchange(_state.undo, false)) _history.undo(_state.scene);
    if (std::exchange(_state.redo, false)) _history.redo(_state.scene);
    _history.follow(_state.scene, ImGui::IsAnyMouseDown() || ImGui::IsAnyItemActive());
    _window.setFullscreen(_state.fullscreen);
    try {
        saveWhatIsAsked();
    } catch (const InputError& error) {
        fail(error);
    }
}

/// What compiles takes over; what does not is told, and leaves the picture as it was.
void Viewer::reloadShaders() {
    if (!_shaders.changed()) return;
    try {
        _stage.reloadShaders();
        _state.message.clear();
        _state.notice = "shaders reloaded";
    } catch (const GraphicsError& error) {
        fail(error);
    }
}

void Viewer::saveWhatIsAsked() {
    if (const std::string file = std::exchange(_state.saveScene, ""); !file.empty()) {
        saveScene(*_document, _state.scene, file);
        _state.notice = fmt::format("saved {}", file);
    }
    const bool complete = _stage.display() && _stage.rests();
    if (_state.savePicture && complete) {
        _state.savePicture = false;
        _state.notice = fmt::format("saved {}", savePicture(*_stage.display(), _state.file).string());
    }
    if (std::exchange(_state.record, false)) {
        if (_recorder) _state.notice = _recorder->summary();
        if (_recorder)
            _recorder.reset();
        else
            _recorder.emplace(_state.file, _state.time);
        _state.recording = _recorder.has_value();
        _state.playing = false;
    } else if (_recorder && complete && _state.time == _recorder->time()) {
        _recorder->add(*_stage.display());
        _state.time = _recorder->time();
        _state.notice = _recorder->summary();
    }
}

void Viewer::advanceTime(double seconds) {
    // A frame that took long must not make the water leap.
    if (_state.playing) _state.time += std::min(seconds, 0.2);
    if (const int step = std::exchange(_state.step, 0); step != 0) {
        _state.playing = false;
        _state.time = (std::round(_state.time * framesPerSecond) + step) / framesPerSecond;
    }
}

void Viewer::makePicture(const Layout& layout) {
    if (!_state.hasScene()) return;
    _better = false;
    _state.shown.exposure = _state.scene.camera.exposure;
    try {
        Wanted wanted{_state.scene, _state.time, layout.picture.size, _state.other};
        // It is the display that exposes.
        wanted.scene.camera.exposure = 0;
        _stage.want(wanted);
        _stage.setShown(_state.shown);
        if (_recorder || _state.savePicture || !_options.screenshot.empty()) _stage.hurry();
        _better = _worked = _stage.work();
        if (_better) _measured.add(_stage.passes());
        _worked = _worked || _stage.refines();
    } catch (const InputError& error) {
        fail(error);
    } catch (const gl::ContextLost&) {
        throw;
    } catch (const GraphicsError& error) { // no room, say: the user may ask for less
        fail(error);
    }
}

/// The picture of this frame is in the window; what the user did was taken at `taken`.
void Viewer::looked(Clock::time_point taken) {
    const auto now = Clock::now();
    if (_measured.firstPictureMs == 0 && _stage.display())
        _measured.firstPictureMs = Ms(now - _options.begin).count();
    else if (_state.scene != _before && _state.hasScene())
        _measured.answersMs.push_back(Ms(now - taken).count());
    _before = _state.scene;
    if (const bool rests = _state.hasScene() && _stage.rests(); rests != _rested) {
        _rested = rests;
        if (rests && _options.verbose) {
            fmt::print("picture complete at {:.3f} s\n", Ms(now - _options.begin).count() / 1000);
            std::fflush(stdout);
        }
    }
    if (_stage.rests() || _state.playing || !_state.hasScene()) ++_completeFrames;
}

void Viewer::takeScreenshot() {
    if (_options.screenshot.empty() || _completeFrames < _options.afterFrames) return;
    const glm::ivec2 size = _window.size();
    io::writePng(_options.screenshot, size.x, size.y, _window.pixels());
    _done = true;
}

void Viewer::frame() {
    _window.waitForEvents(waitingTime());
    const auto taken = Clock::now();
    // Dear ImGui takes a few frames to settle after something happened.
    _lively = _window.hasEvents() ? 3 : std::max(_lively - 1, 0);
    const double seconds = Ms(taken - _last).count() / 1000;
    _last = taken;
    if (_window.hidden()) return;
    _window.beginInterface();
    Layout layout = layoutOf(_state, _window.size());
    if (takeInput(_state, layout.picture, seconds)) _lively = 3;
    drawInterface({_state, _stage, _context, _measured, _understanding}, layout);
    doRequests();
    reloadShaders();
    advanceTime(seconds);
    layout = layoutOf(_state, _window.size());
    makePicture(layout);
    drawPicture(_stage, layout);
    _understanding.update(_state, _stage, _better);
    _understanding.overlay(_state, _stage, layout.picture);
    drawGizmo(_state, layout.picture);
    compareOverlay(_state, layout.picture);
    _window.endInterface([&] { takeScreenshot(); });
    looked(taken);
}

void Viewer::report() const {
    fmt::print("first picture after {:.0f} ms\n", _measured.firstPictureMs);
    if (!_measured.answersMs.empty())
        fmt::print("{} changes answered in {:.0f} ms (median)\n", _measured.answersMs.size(),
                   spreadOf(_measured.answersMs).median);
}

} // namespace

void show(const Options& options) {
    Viewer(options).run();
}

} // namespace limpid::viewer
