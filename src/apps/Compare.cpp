#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/Common.h"
#include "apps/Comparison.h"
#include "core/Error.h"
#include "io/Files.h"
#include "io/bake/BakedFolder.h"
#include "io/images/Images.h"

namespace fs = std::filesystem;

namespace limpid::apps {

namespace {

using Json = nlohmann::ordered_json;

/// A figure and the option that limits it.
struct Limit {
    const char* option;
    const char* figure;
    const char* help;
    double (*value)(const ImageErrors&);
    bool least = false; ///< the figure may not be smaller, instead of larger
};

constexpr std::array<Limit, 7> figures{{
    {"--max-luv", "Luv", "mean distance in CIE Luv (thesis eq. 2-9)",
     [](const ImageErrors& e) { return e.luv; }},
    {"--max-nmae", "nMAE", "mean absolute error / mean of B", [](const ImageErrors& e) { return e.nmae; }},
    {"--max-nrmse", "nRMSE", "root of the mean square error / mean of B",
     [](const ImageErrors& e) { return e.nrmse; }},
    {"--max-relmse", "relMSE", "mean of the squared relative error",
     [](const ImageErrors& e) { return e.relmse; }},
    {"--min-psnr", "PSNR", "peak over root mean square error, dB",
     [](const ImageErrors& e) { return e.psnr; }, true},
    {"--max-error", "largest error", "of any channel of any pixel",
     [](const ImageErrors& e) { return e.largest; }},
    {"--max-flux", "|flux ratio - 1|", "of the light that the two hold in all",
     [](const ImageErrors& e) { return std::abs(e.fluxRatio - 1); }},
}};

struct CompareOptions {
    std::string a, b, mask, diff;
    std::array<std::optional<double>, figures.size()> limits; ///< by figure
    bool json = false;
    bool quiet = false;
};

/// One line for each limit that the item is beyond. A figure that is no number is beyond any limit; an item
/// that neither of the two sees anything of has no figures.
void judge(const ComparedItem& item, const CompareOptions& options, std::vector<std::string>& beyond) {
    const ImageErrors& errors = item.errors;
    bool limited = false;
    for (std::size_t i = 0; i < figures.size(); ++i) {
        if (!options.limits[i]) continue;
        limited = true;
        const double value = figures[i].value(errors), limit = *options.limits[i];
        const bool within = figures[i].least ? value >= limit : value <= limit;
        const bool nothing = errors.pixels == 0 && item.unmatched == 0 && errors.notFiniteInA == 0;
        if (!within && !nothing)
            beyond.push_back(fmt::format("{}: {} {:.6g} is beyond {} {:.6g}", item.title, figures[i].figure,
                                         value, figures[i].option, limit));
    }
    if (limited && errors.notFiniteInA > 0)
        beyond.push_back(fmt::format("{}: pixels of A that are not finite, which no limit allows: {}",
                                     item.title, errors.notFiniteInA));
}

Json itemJson(const ComparedItem& item) {
    Json json;
    if (item.receiver.empty()) {
        json["picture"] = true;
    } else {
        json["receiver"] = item.receiver;
        json["light"] = item.light;
        if (item.facing > 0) json["facing"] = item.facing;
    }
    const ImageErrors& e = item.errors;
    json["size"] = {item.size.x, item.size.y};
    json["pixels"] = e.pixels;
    json["unmatched"] = item.unmatched;
    json["not_finite"] = {{"a", e.notFiniteInA}, {"b", e.notFiniteInB}};
    json["mean"] = e.mean;
    json["error"] = {
        {"nmae", e.nmae},
        {"nrmse", e.nrmse},
        {"relmse", e.relmse},
        {"psnr", e.psnr},
        {"luv", e.luv},
        {"flux_ratio", e.fluxRatio},
        {"largest",
         {{"value", e.largest},
          {"at", {e.largestAt % std::size_t(item.size.x), e.largestAt / std::size_t(item.size.x)}}}}};
    if (item.standardError) json["standard_error"] = *item.standardError;
    return json;
}

void printJson(const CompareOptions& options, const Comparison& comparison,
               const std::vector<std::string>& beyond) {
    Json json = {{"limpid", LIMPID_VERSION},
                 {"a", options.a},
                 {"b", options.b},
                 {"values", comparison.stored  ? "sRGB as stored"
                            : comparison.bakes ? "W/m²"
                                               : "linear"}};
    json["compared"] = Json::array();
    for (const ComparedItem& item : comparison.items)
        json["compared"].push_back(itemJson(item));
    json["beyond"] = beyond;
    fmt::print("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace));
}

void printItem(const ComparedItem& item, int width) {
    const ImageErrors& e = item.errors;
    fmt::print("{:<{}} {:>9} {:>9.4g} {:>9.4g} {:>9.4g} {:>8.4g} {:>8.4g} {:>10.6g} {:>9.4g} at {},{}",
               item.title, width, e.pixels, e.nmae, e.nrmse, e.relmse, e.psnr, e.luv, e.fluxRatio, e.largest,
               e.largestAt % std::size_t(item.size.x), e.largestAt / std::size_t(item.size.x));
    if (item.standardError) fmt::print("   (nMAE by chance {:.2g})", *item.standardError);
    fmt::print("\n");
    if (item.unmatched > 0)
        fmt::print("{:<{}} pixels left out, on the object in only one of the two: {}\n", "", width,
                   item.unmatched);
    if (e.notFiniteInA + e.notFiniteInB > 0)
        fmt::print("{:<{}} pixels left out, not finite: {} of A, {} of B\n", "", width, e.notFiniteInA,
                   e.notFiniteInB);
}

void printTable(const Comparison& comparison) {
    std::size_t width = 7;
    for (const ComparedItem& item : comparison.items)
        width = std::max(width, item.title.size());
    fmt::print("{:<{}} {:>9} {:>9} {:>9} {:>9} {:>8} {:>8} {:>10} {:>9}\n", "", width, "pixels", "nMAE",
               "nRMSE", "relMSE", "PSNR", "Luv", "flux ratio", "largest");
    for (const ComparedItem& item : comparison.items)
        printItem(item, int(width));
}

void requireDiffName(const fs::path& file, bool bakes) {
    if (bakes)
        io::prepareFolder(file);
    else if (const std::string suffix = io::lowerCaseSuffix(file); suffix != ".png" && suffix != ".exr")
        throw InputError(fmt::format("--diff: {}: expected a name that ends in .png or .exr, found \"{}\"",
                                     io::oneLine(file.string()), io::oneLine(file.extension().string())));
}

void writeDifference(const fs::path& file, const ComparedItem& item) {
    if (io::lowerCaseSuffix(file) == ".png") {
        io::writePng(file, item.size.x, item.size.y, differencePicture(item.images, item.errors.mean));
        return;
    }
    const ImagePair& pair = item.images;
    std::vector<float> difference(pair.a.size());
    for (std::size_t i = 0; i < difference.size(); ++i)
        if (pair.mask.empty() || pair.mask[i / 3] > 0) difference[i] = pair.a[i] - pair.b[i];
    io::writeExr(file, item.size.x, item.size.y, {"R", "G", "B"}, difference);
}

void writeDifferences(const fs::path& out, const Comparison& comparison) {
    for (const ComparedItem& item : comparison.items) {
        if (!comparison.bakes) {
            writeDifference(out, item);
            continue;
        }
        std::string name = fmt::format("{}.{}", item.receiver, item.light);
        if (item.facing > 0) name += fmt::format(".facing{}", item.facing);
        for (const char* suffix : {"exr", "png"})
            writeDifference(out / fmt::format("{}.difference.{}", name, suffix), item);
    }
}

void runCompare(const CompareOptions& options) {
    if (!options.diff.empty()) requireDiffName(options.diff, fs::is_directory(options.b));
    const Comparison comparison = compare(options.a, options.b, options.mask);
    std::vector<std::string> beyond;
    for (const ComparedItem& item : comparison.items)
        judge(item, options, beyond);
    if (!options.diff.empty()) writeDifferences(options.diff, comparison);
    if (!options.quiet)
        for (const std::string& warning : comparison.warnings)
            fmt::print(stderr, "limpid: warning: {}\n", warning);
    if (options.json)
        printJson(options, comparison, beyond);
    else if (!options.quiet)
        printTable(comparison);
    for (const std::string& line : beyond)
        fmt::print(stderr, "limpid: {}\n", line);
    if (!beyond.empty()) throw Exit{1};
}

} // namespace

void addCompare(CLI::App& app) {
    auto* command =
        app.add_subcommand("compare", "error figures of two pictures, or of two baked folders map by map");
    command->footer("Examples:\n  limpid compare maps truth --max-nmae 0.02 --json");
    auto options = std::make_shared<CompareOptions>();
    command->add_option("A", options->a, "picture or baked folder")->required();
    command->add_option("B", options->b, "the same of the truth")->required();
    command->add_option("--mask", options->mask, "picture: compare where it is above 0");
    command->add_option(
        "--diff", options->diff,
        "write A - B: .exr, or .png with red where A is brighter and blue where it is darker, "
        "full at B's mean; of baked folders a folder with both");
    for (std::size_t i = 0; i < figures.size(); ++i)
        command->add_option(figures[i].option, options->limits[i],
                            fmt::format("exit with 1 beyond: {}", figures[i].help));
    command->add_flag("--json", options->json, "as JSON; null for what is infinite or no number");
    command->add_flag("--quiet", options->quiet, "print only what is beyond a limit");
    command->callback([options] { runCompare(*options); });
}

} // namespace limpid::apps
