#pragma once
#include <chrono>
#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "apps/viewer/Display.h"
#include "apps/viewer/Gizmo.h"
#include "scene/Scene.h"

namespace limpid::viewer {

/// What panels and keys change, as plain data; the window shows it.
struct State {
    std::filesystem::path file;      ///< empty without a scene
    Scene loaded;                    ///< as the file has it, choices of the engine filled in
    Scene scene;                     ///< as it is now
    double extent = 1;               ///< m, from corner to corner of what was loaded
    std::vector<glm::dvec3> middles; ///< of each receiver's mesh, in its own space
    double time = 0;                 ///< s
    bool playing = false;
    std::optional<int> selected; ///< receiver
    Gizmo::Mode gizmo = Gizmo::Mode::Move;
    std::optional<int> handle;     ///< of the gizmo, that the mouse is at or has
    std::optional<GizmoDrag> drag; ///< of that handle
    int light = 0;                 ///< that maps and beams are shown of

    bool panels = true;                                                       ///< all of the interface
    bool keys = false;                                                        ///< what `?` shows
    enum class Side { None, Measure, Understand, Compare } side = Side::None; ///< the panel on the right
    bool boxes = false, planes = false, beams = false;                        ///< drawn over the scene
    std::optional<Method> other;                                              ///< compared with
    Shown shown;
    std::string message; ///< what went wrong last; empty: nothing
    std::string notice;  ///< what went well last

    // Asked for by a panel or a key, done by the viewer.
    bool askOpen = false; ///< which file to open
    std::string openName; ///< as it is being typed
    std::string open;     ///< a file
    bool savePicture = false;
    bool askSave = false;  ///< where to save the scene
    std::string saveName;  ///< as it is being typed
    std::string saveScene; ///< a file
    bool record = false;   ///< toggles
    bool frameSelection = false;
    bool resetCamera = false;
    int step = 0; ///< frames of time
    bool undo = false, redo = false;
    bool leave = false;

    bool recording = false;
    bool fullscreen = false;

    bool hasScene() const { return !file.empty(); }
};

/// What the measure panel shows: the last pictures' times by pass, ms, oldest first.
struct Measured {
    using Clock = std::chrono::steady_clock;
    static constexpr std::size_t kept = 120;
    struct Frame {
        std::vector<std::pair<std::string, double>> passes;
    };
    std::deque<Frame> frames;
    std::deque<Clock::time_point> shown; ///< when the last second's pictures came
    std::vector<double> answersMs;       ///< from taking a change of the user's to its picture in the window
    double firstPictureMs = 0;           ///< from the start of the program

    void add(const std::vector<std::pair<std::string, double>>& passes) {
        frames.push_back({passes});
        if (frames.size() > kept) frames.pop_front();
        shown.push_back(Clock::now());
    }
    /// Pictures in the last second.
    int perSecond() {
        while (!shown.empty() && Clock::now() - shown.front() > std::chrono::seconds(1))
            shown.pop_front();
        return int(shown.size());
    }
};

} // namespace limpid::viewer
