#include <fmt/format.h>

#include "apps/Common.h"
#include "apps/EngineUse.h"
#include "apps/profile/GroundTruth.h"
#include "apps/profile/Machine.h"
#include "apps/profile/Output.h"
#include "apps/profile/Plots.h"
#include "apps/profile/Run.h"
#include "core/Error.h"
#include "io/Files.h"
#include "io/bake/BakedFolder.h"

namespace fs = std::filesystem;

namespace limpid::apps {

namespace {

struct ProfileOptions {
    std::vector<std::string> files;
    std::string output;
    std::vector<std::string> receivers;
    std::optional<int> frames;
    std::optional<std::int64_t> reference;
    std::string device;
    bool quiet = false;
};

/// The profile's file with what the command line says in place of it.
io::Profile loadProfile(const std::string& file, const ProfileOptions& options) {
    io::Profile profile = io::loadProfile(file);
    if (options.frames) profile.frames = *options.frames;
    if (options.reference) profile.reference = *options.reference;
    if (options.receivers.empty()) return profile;
    profile.receivers.clear();
    for (const std::string& models : options.receivers)
        for (io::ProfileReceiver& receiver : io::modelReceivers(models))
            profile.receivers.push_back(std::move(receiver));
    return profile;
}

ProfileOutcome joined(ProfileOutcome all, const ProfileOutcome& one) {
    all.results.insert(all.results.end(), one.results.begin(), one.results.end());
    all.histograms.insert(all.histograms.end(), one.histograms.begin(), one.histograms.end());
    all.godrays.insert(all.godrays.end(), one.godrays.begin(), one.godrays.end());
    return all;
}

/// A profile that lists ways to draw light in the water measures these, any other one caustics.
ProfileOutcome measured(gl::Context& context, const io::Profile& profile, const ProfileRunOptions& options) {
    if (profile.godrays.empty()) return runProfile(context, profile, options);
    ProfileOutcome outcome;
    outcome.godrays = profileGodrays(context, profile, options.references, options.quiet);
    return outcome;
}

void runProfiles(const ProfileOptions& options) {
    std::vector<io::Profile> profiles;
    for (const std::string& file : options.files) {
        profiles.push_back(loadProfile(file, options));
        for (const io::Profile& other : profiles)
            if (&other != &profiles.back() && other.name == profiles.back().name)
                throw InputError(fmt::format(
                    "{}: expected profiles of different names, found two named \"{}\"", file, other.name));
    }
    io::prepareFolder(options.output);
    const fs::path folder = options.output;
    gl::ContextOptions contextOptions;
    contextOptions.device = options.device;
    gl::Context context(contextOptions);
    const Machine machine = thisMachine(context.info());
    ProfileOutcome outcome;
    const auto keep = [&](const ProfileOutcome& all) {
        io::writeText(folder / "results.json", resultsJson(profiles, all, machine));
        io::writeText(folder / "results.csv", resultsCsv(all));
        if (!all.godrays.empty()) io::writeText(folder / "godrays.csv", godraysCsv(all.godrays));
    };
    for (const io::Profile& profile : profiles) {
        if (profile.reference > 0 && !canTraceGroundTruth() && !options.quiet)
            fmt::print(stderr,
                       "limpid: warning: {}: this build has no ray tracer (LIMPID_REFERENCE), so there "
                       "are no error figures\n",
                       profile.name);
        const auto keepMore = [&](const ProfileOutcome& more) { keep(joined(outcome, more)); };
        outcome = joined(std::move(outcome),
                         measured(context, profile, {folder / "references", options.quiet, keepMore}));
    }
    keep(outcome);
    if (!options.quiet) printResults(outcome, machine);
    for (const io::Profile& profile : profiles)
        if (profile.godrays.empty()) plotResults(folder, profile, outcome, machine);
}

} // namespace

void addProfile(CLI::App& app) {
    auto* command =
        app.add_subcommand("profile", "measures what profiles list: times, memory, errors; plots");
    command->footer("Examples:\n  limpid profile profiles/quick.toml -o out");
    auto options = std::make_shared<ProfileOptions>();
    command->add_option("PROFILE", options->files, "profiles (.toml)")->required();
    command->add_option("-o,--output", options->output, "folder to write to")->required();
    command
        ->add_option("--receiver", options->receivers,
                     "model, or folder of models, in place of the profile's receivers (repeatable)")
        ->allow_extra_args(false)
        ->take_all();
    command->add_option("--frames", options->frames, "timed frames of each combination")
        ->check(CLI::Range(1, 100000));
    command->add_option("--reference", options->reference, "photons of the ground truth; 0: no error figures")
        ->check(CLI::Range(std::int64_t(0), std::int64_t(1000000000000)));
    command->add_option("--device", options->device, "EGL device, by number or part of its name");
    command->add_flag("--quiet", options->quiet, "print errors only");
    command->callback([options] { runProfiles(*options); });
}

} // namespace limpid::apps
