#include "apps/profile/Godrays.h"

#include <fmt/format.h>

#include "apps/profile/GodrayTruth.h"
#include "apps/profile/Run.h"
#include "core/Error.h"
#include "core/Progress.h"
#include "engine/Engine.h"

namespace limpid::apps {

namespace {

/// A scene, its pictures with and without, and what is known of its light.
struct Subject {
    std::string name;
    Scene scene; ///< its camera placed
    Picture without;
    std::optional<ScatteredPicture> truth;
};

struct Series {
    std::size_t subject = 0;
    GodrayResult result;
    std::vector<double> ms;
};

std::vector<Subject> loadSubjects(const io::Profile& profile) {
    std::vector<Subject> subjects;
    for (const std::filesystem::path& file : profile.scenes) {
        Scene scene = io::loadScene(file, profile.settings);
        const Camera& camera = scene.camera;
        if (!camera.position || !camera.target || camera.position->y >= scene.water.level)
            throw InputError(
                fmt::format("{}: godrays: expected a camera under the water, found none", file.string()));
        subjects.push_back({sceneName(file), std::move(scene), {}, {}});
    }
    return subjects;
}

std::vector<Series> combine(const io::Profile& profile, const std::vector<Subject>& subjects) {
    std::vector<Series> all;
    for (std::size_t i = 0; i < subjects.size(); ++i)
        for (const std::string& toml : profile.godrays) {
            std::vector<io::Override> overrides = profile.settings;
            overrides.push_back({"godrays", toml});
            Series& series = all.emplace_back();
            series.subject = i;
            series.result.profile = profile.name;
            series.result.scene = subjects[i].name;
            series.result.settings = io::loadScene(profile.scenes[i], overrides).godrays;
        }
    return all;
}

Scene sceneOf(const Subject& subject, const GodraySettings& settings) {
    Scene scene = subject.scene;
    scene.godrays = settings;
    return scene;
}

ImageErrors errorOf(const Picture& with, const Subject& subject) {
    std::vector<float> added;
    for (std::size_t i = 0; i < with.rgb.size(); ++i)
        added.push_back(with.rgb[i] - subject.without.rgb[i]);
    return imageErrors({added, subject.truth->rgb});
}

class GodrayRun {
  public:
    GodrayRun(gl::Context& context, const io::Profile& profile)
        : _context(context), _profile(profile), _engine(context), _subjects(loadSubjects(profile)),
          _series(combine(profile, _subjects)) {}

    std::vector<GodrayResult> run(const std::filesystem::path& references, bool quiet);

  private:
    void prepare(Subject& subject);
    void time(Series& series);

    gl::Context& _context;
    const io::Profile& _profile;
    Engine _engine;
    std::vector<Subject> _subjects;
    std::vector<Series> _series;
    std::optional<std::size_t> _placed; ///< the subject that the engine has
};

/// Caustics are made once: they are no part of what is timed.
void GodrayRun::prepare(Subject& subject) {
    const auto index = std::size_t(&subject - _subjects.data());
    if (_placed == index) return;
    GodraySettings none;
    none.method = GodrayMethod::None;
    _engine.set(sceneOf(subject, none));
    _engine.updateCaustics(_profile.time);
    if (subject.without.rgb.empty()) subject.without = _engine.draw(_profile.picture);
    _placed = index;
}

void GodrayRun::time(Series& series) {
    Subject& subject = _subjects[series.subject];
    prepare(subject);
    _engine.set(sceneOf(subject, series.result.settings));
    const bool first = series.ms.empty();
    for (int i = 0; i < (first ? std::max(_profile.warmup, 1) : _profile.warmup); ++i)
        _engine.draw(_profile.picture);
    _engine.timers().collect();
    const Picture picture = _engine.draw(_profile.picture);
    double ms = 0;
    for (const auto& [pass, passed] : _engine.timers().collect())
        if (pass == "godrays") ms += passed;
    series.ms.push_back(ms);
    if (!first) return;
    for (const auto& [kind, bytes] : _context.ledger().byKind())
        if (kind == "godrays" || kind == "photon lines" || kind == "lit water" ||
            kind == "illumination volumes")
            series.result.bytes += bytes;
    if (!subject.truth) return;
    series.result.error = errorOf(picture, subject);
    series.result.standardError = subject.truth->standardError;
}

std::vector<GodrayResult> GodrayRun::run(const std::filesystem::path& references, bool quiet) {
    if (_profile.reference > 0)
        for (Subject& subject : _subjects)
            subject.truth = scatteredPicture(references, subject.name, subject.scene, _profile.time,
                                             _profile.reference, _profile.picture);
    Progress progress(fmt::format("{}: pictures", _profile.name), _profile.frames * int(_series.size()),
                      !quiet);
    int done = 0;
    for (int round = 0; round < _profile.frames; ++round)
        for (Series& series : _series) {
            progress.update(done++);
            time(series);
        }
    std::vector<GodrayResult> results;
    for (Series& series : _series) {
        series.result.ms = spreadOf(series.ms);
        results.push_back(std::move(series.result));
    }
    return results;
}

std::string gridOf(const GodraySettings& settings) {
    const glm::ivec2 grid = settings.grid * settings.subdivision;
    return fmt::format("{}x{}", grid.x, grid.y);
}

} // namespace

std::vector<GodrayResult> profileGodrays(gl::Context& context, const io::Profile& profile,
                                         const std::filesystem::path& references, bool quiet) {
    return GodrayRun(context, profile).run(references, quiet);
}

std::string godraysCsv(const std::vector<GodrayResult>& results) {
    std::string csv =
        "profile,scene,method,grid,scale,planes,steps,sub_volumes,ms:min,ms:median,ms:p95,bytes,"
        "error:nmae,error:nrmse,error:flux_ratio,standard_error\n";
    for (const GodrayResult& r : results) {
        const GodraySettings& s = r.settings;
        csv += fmt::format("{},{},{},{},{:.6g},{},{},{},{:.6g},{:.6g},{:.6g},{}", r.profile, r.scene,
                           godrayMethodName(s.method), gridOf(s), s.scale, s.planes, s.steps, s.subVolumes,
                           r.ms.min, r.ms.median, r.ms.p95, r.bytes);
        csv += r.error ? fmt::format(",{:.6g},{:.6g},{:.6g},{:.6g}\n", r.error->nmae, r.error->nrmse,
                                     r.error->fluxRatio, *r.standardError)
                       : ",,,,\n";
    }
    return csv;
}

void printGodrays(const std::vector<GodrayResult>& results) {
    std::size_t scene = 5;
    for (const GodrayResult& r : results)
        scene = std::max(scene, r.scene.size());
    fmt::print("{:<{}} {:<14} {:>11} {:>6} {:>11} {:>8} {:>8} {:>10} {:>8}\n", "scene", scene, "godrays",
               "grid", "scale", "godrays ms", "MiB", "nMAE", "flux ratio", "chance");
    for (const GodrayResult& r : results) {
        fmt::print("{:<{}} {:<14} {:>11} {:>6.2f} {:>11.2f} {:>8.2f}", r.scene, scene,
                   godrayMethodName(r.settings.method), gridOf(r.settings), r.settings.scale, r.ms.median,
                   double(r.bytes) / (1 << 20));
        if (r.error)
            fmt::print(" {:>8.4f} {:>10.5f} {:>8.4f}", r.error->nmae, r.error->fluxRatio, *r.standardError);
        fmt::print("\n");
    }
}

} // namespace limpid::apps
