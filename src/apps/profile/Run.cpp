#include "apps/profile/Run.h"

#include <algorithm>
#include <chrono>

#include <fmt/format.h>

#include "apps/BakedMaps.h"
#include "apps/profile/GroundTruth.h"
#include "core/Progress.h"
#include "engine/Readback.h"
#include "gl/Api.h"
#include "io/bake/BakeErrors.h"
#include "scene/MethodFacts.h"

namespace limpid::apps {

namespace {

using Clock = std::chrono::steady_clock;

/// Seldom enough that to write what there is costs little beside what is measured.
constexpr std::chrono::seconds keepEvery{2};

double milliseconds(Clock::time_point from, Clock::time_point to) {
    return std::chrono::duration<double, std::milli>(to - from).count();
}

/// A scene with the receivers that it is measured with.
struct Subject {
    std::string sceneName, receiverName;
    Scene scene;
};

/// One combination and what its frames took.
struct Series {
    std::size_t subject = 0;
    CausticsSettings caustics;
    glm::ivec2 grid{0};
    ProfileResult result;
    std::vector<double> wall, update;
    std::vector<std::pair<std::string, std::vector<double>>> gpu;

    bool sameScene(const Series& other) const { return subject == other.subject && grid == other.grid; }
    bool sameButMethod(const Series& other) const {
        return sameScene(other) && caustics.planes == other.caustics.planes &&
               caustics.mapSize == other.caustics.mapSize;
    }
};

/// 1 m along its longest side, standing on y = 0, in the middle.
void bringToOneMetre(Receiver& receiver) {
    const Bounds bounds = worldBounds(receiver);
    const glm::dvec3 size = bounds.size();
    const double scale = 1 / std::max({size.x, size.y, size.z, 1e-12});
    receiver.scale = glm::dvec3(scale);
    receiver.translation = -scale * glm::dvec3(bounds.center().x, bounds.min.y, bounds.center().z);
}

/// What a table has room for.
std::string nameOfAll(const Scene& scene) {
    const std::size_t count = scene.receivers.size();
    return count > 3 ? fmt::format("{} receivers", count) : receiverNames(scene);
}

std::vector<Subject> loadSubjects(const io::Profile& profile) {
    std::vector<Subject> subjects;
    for (const std::filesystem::path& file : profile.scenes) {
        if (profile.receivers.empty()) {
            Scene scene = io::loadScene(file, profile.settings);
            subjects.push_back({sceneName(file), nameOfAll(scene), std::move(scene)});
        }
        for (const io::ProfileReceiver& receiver : profile.receivers) {
            std::vector<io::Override> overrides{{"receiver", receiver.toml}};
            overrides.insert(overrides.end(), profile.settings.begin(), profile.settings.end());
            Scene scene = io::loadScene(file, overrides);
            if (receiver.model) bringToOneMetre(scene.receivers.front());
            subjects.push_back({sceneName(file), receiver.name, std::move(scene)});
        }
    }
    return subjects;
}

template <typename Value>
std::vector<Value> orElse(std::vector<Value> values, const Value& only) {
    if (values.empty()) values.push_back(only);
    return values;
}

/// The baseline goes first, for the others to be compared with.
std::vector<Method> methodsOf(const io::Profile& profile, const Scene& scene) {
    std::vector<Method> methods = orElse(profile.methods, scene.caustics.method);
    std::stable_partition(methods.begin(), methods.end(),
                          [&](Method method) { return method == profile.baseline; });
    return methods;
}

struct Way {
    Method method;
    Fill fill;
};

/// Every method with every fill that it has; the baseline with its first fill stays in front.
std::vector<Way> waysOf(const io::Profile& profile, const Scene& scene) {
    std::vector<Way> ways;
    for (const Method method : methodsOf(profile, scene)) {
        const std::vector<Fill> fills = orElse(profile.fills, scene.caustics.fill);
        for (const Fill fill : fills)
            if (factsOf(method).fills || fill == fills.front())
                ways.push_back({method, fillOf(method, fill)});
    }
    return ways;
}

/// Methods innermost, so that a map is compared with the baseline's right after that was made; what costs
/// most to change outermost.
std::vector<Series> combine(const io::Profile& profile, const std::vector<Subject>& subjects) {
    std::vector<Series> all;
    for (std::size_t subject = 0; subject < subjects.size(); ++subject) {
        const Scene& scene = subjects[subject].scene;
        const CausticsSettings& own = scene.caustics;
        for (const int mapSize : orElse(profile.mapSizes, own.mapSize))
            for (const glm::ivec2 grid : orElse(profile.grids, scene.water.grid))
                for (const int planes : orElse(profile.planes, own.planes))
                    for (const auto& [method, fill] : waysOf(profile, scene)) {
                        Series& series = all.emplace_back();
                        series.subject = subject;
                        series.grid = grid;
                        series.caustics = own;
                        series.caustics.method = method;
                        series.caustics.fill = fill;
                        series.caustics.planes = planes;
                        series.caustics.mapSize = mapSize;
                        series.result.profile = profile.name;
                        series.result.scene = subjects[subject].sceneName;
                        series.result.receiver = subjects[subject].receiverName;
                        series.result.method = methodName(method);
                        series.result.fill = fillName(fill);
                        series.result.planes = planes;
                        series.result.mapSize = mapSize;
                        series.result.grid = grid;
                    }
    }
    return all;
}

class Run {
  public:
    Run(gl::Context& context, const io::Profile& profile, const ProfileRunOptions& options)
        : _context(context), _profile(profile), _options(options), _engine(context),
          _subjects(loadSubjects(profile)), _series(combine(profile, _subjects)),
          _truth(options.references, profile.reference, profile.time, options.quiet),
          _judged(profile.reference > 0 && canTraceGroundTruth()) {}

    ProfileOutcome run();

  private:
    Scene sceneOf(const Series& series) const;
    void traceGroundTruth();
    void warmUp(int updates);
    void time(Series& series);
    void describeWork(Series& series, std::int64_t peak);
    void compareMaps(Series& series);
    void countTexels(const Series& series);
    ProfileOutcome soFar() const;

    gl::Context& _context;
    const io::Profile& _profile;
    const ProfileRunOptions& _options;
    Engine _engine;
    std::vector<Subject> _subjects;
    std::vector<Series> _series;
    GroundTruth _truth;
    bool _judged;
    const Series* _baseline = nullptr; ///< whose maps `_baselineMaps` are
    io::Bake _baselineMaps;
    std::vector<DepthHistogram> _histograms;
};

Scene Run::sceneOf(const Series& series) const {
    Scene scene = _subjects[series.subject].scene;
    scene.caustics = series.caustics;
    scene.water.grid = series.grid;
    return scene;
}

/// Before anything is timed, so that the tracer's threads disturb no frame.
void Run::traceGroundTruth() {
    for (const Series& series : _series)
        _truth.maps(sceneOf(series));
}

/// Where something may be reused, water that stood still would leave nothing to do: it moves on by 1/30 s
/// with each update, to the profile's time.
void Run::warmUp(int updates) {
    for (int left = updates; left > 0; --left)
        _engine.updateCaustics(_profile.reuse ? _profile.time - left / 30.0 : _profile.time);
    glFinish();
    _engine.timers().collect();
}

void Run::time(Series& series) {
    const bool first = series.wall.empty();
    _engine.set(sceneOf(series));
    // The first visit of all compiles and allocates, whatever the profile says.
    warmUp(first ? std::max(_profile.warmup, 1) : _profile.warmup);
    if (first) _engine.freePicture(); // memory is the caustics' alone
    _context.ledger().resetPeak();
    const Clock::time_point begin = Clock::now();
    _engine.updateCaustics(_profile.time);
    glFinish();
    const Clock::time_point updated = Clock::now();
    const std::int64_t peak = _context.ledger().peak();
    _engine.draw(_profile.picture);
    const Clock::time_point drawn = Clock::now();
    series.update.push_back(milliseconds(begin, updated));
    series.wall.push_back(milliseconds(begin, drawn));
    for (const auto& [pass, ms] : _engine.timers().collect()) {
        auto entry = std::find_if(series.gpu.begin(), series.gpu.end(),
                                  [&pass = pass](const auto& known) { return known.first == pass; });
        if (entry == series.gpu.end()) entry = series.gpu.insert(entry, {pass, {}});
        entry->second.push_back(ms);
    }
    if (!first) return;
    _engine.freePicture();
    describeWork(series, peak);
    compareMaps(series);
    countTexels(series);
}

void Run::describeWork(Series& series, std::int64_t peak) {
    ProfileResult& result = series.result;
    for (const auto& [kind, bytes] : _context.ledger().byKind())
        result.bytes.emplace_back(kind, bytes);
    result.bytes.emplace_back("total", _context.ledger().total());
    result.bytes.emplace_back("peak", peak);
    result.skipped = _engine.skipped().byKind();
    const Scene& scene = _engine.scene();
    for (const MapWork& maps : _engine.maps()) {
        const int drawn = factsOf(series.caustics.method).planes ? int(maps.level.planes.size()) : 0;
        result.maps.push_back({scene.receivers[std::size_t(maps.plan.receiver)].name,
                               scene.lights[std::size_t(maps.plan.light)].name, maps.level.facing,
                               maps.level.frame.size, drawn});
        result.planesDrawn += drawn;
    }
    for (int light = 0; light < int(scene.lights.size()); ++light)
        result.beamsDrawn += _engine.beamsDrawn(light);
}

void Run::compareMaps(Series& series) {
    const bool toBaseline = _profile.baseline.has_value();
    if (!_judged && !toBaseline) return;
    io::Bake ours;
    ours.origin = _engine.origin();
    ours.maps = bakedMaps(_engine, readAllMaps(_engine));
    if (_judged) {
        const io::Bake& truth = _truth.maps(sceneOf(series));
        series.result.error = io::bakeErrors(ours, truth, series.result.method, "the reference");
        series.result.standardError = io::standardError(truth);
    }
    if (!toBaseline) return;
    const bool compared = _baseline && _baseline->sameButMethod(series);
    if (series.caustics.method == *_profile.baseline && !compared) {
        _baseline = &series;
        _baselineMaps = std::move(ours);
    } else if (compared) {
        series.result.difference =
            io::bakeErrors(ours, _baselineMaps, series.result.method, _baseline->result.method);
    }
}

/// Of each subject, with the most planes that it is measured with; from level maps whose planes are where
/// uniform slicing puts them.
void Run::countTexels(const Series& series) {
    if (series.caustics.slicing != Slicing::Automatic || _engine.maps().empty()) return;
    if (!factsOf(series.caustics.method).fills) return;
    auto own = std::find_if(_histograms.begin(), _histograms.end(), [&](const DepthHistogram& known) {
        return known.scene == series.result.scene && known.receiver == series.result.receiver;
    });
    if (own == _histograms.end())
        own = _histograms.insert(own, {_profile.name, series.result.scene, series.result.receiver, {}});
    if (std::size_t(series.caustics.planes) > own->texels.size())
        own->texels = planeHistogram(_engine.maps().front().level);
}

ProfileResult finished(const Series& series) {
    ProfileResult result = series.result;
    result.wall = spreadOf(series.wall);
    result.caustics = spreadOf(series.update);
    for (const auto& [pass, times] : series.gpu)
        result.gpu.emplace_back(pass, spreadOf(times).median);
    return result;
}

ProfileOutcome Run::soFar() const {
    ProfileOutcome outcome;
    outcome.histograms = _histograms;
    for (const Series& series : _series)
        if (!series.wall.empty()) outcome.results.push_back(finished(series));
    return outcome;
}

ProfileOutcome Run::run() {
    if (_judged) traceGroundTruth();
    _engine.setReuse(_profile.reuse);
    _engine.set(sceneOf(_series.front()));
    _engine.render(_profile.time, _profile.picture); // makes what pictures need
    Progress progress(fmt::format("{}: frames", _profile.name), _profile.frames * int(_series.size()),
                      !_options.quiet);
    Clock::time_point kept = Clock::now();
    int done = 0;
    for (int round = 0; round < _profile.frames; ++round)
        for (Series& series : _series) {
            progress.update(done++);
            time(series);
            if (!_options.keep || Clock::now() - kept < keepEvery) continue;
            _options.keep(soFar());
            kept = Clock::now();
        }
    return soFar();
}

} // namespace

std::string sceneName(const std::filesystem::path& file) {
    return file.stem().string();
}

ProfileOutcome runProfile(gl::Context& context, const io::Profile& profile,
                          const ProfileRunOptions& options) {
    return Run(context, profile, options).run();
}

} // namespace limpid::apps
