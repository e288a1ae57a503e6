#include "apps/profile/Output.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace limpid::apps {

namespace {

using Json = nlohmann::ordered_json;

/// To a tenth of a microsecond.
double rounded(double milliseconds) {
    return std::round(1e4 * milliseconds) / 1e4;
}

Json spreadJson(const Spread& spread) {
    return {{"min", rounded(spread.min)}, {"median", rounded(spread.median)}, {"p95", rounded(spread.p95)}};
}

Json errorJson(const ImageErrors& errors) {
    return {{"nmae", errors.nmae},      {"nrmse", errors.nrmse}, {"relmse", errors.relmse},
            {"luv", errors.luv},        {"psnr", errors.psnr},   {"flux_ratio", errors.fluxRatio},
            {"largest", errors.largest}};
}

Json passesJson(const ProfileResult& result) {
    Json json = Json::object();
    for (const auto& [pass, milliseconds] : result.gpu)
        json[pass] = rounded(milliseconds);
    return json;
}

Json bytesJson(const ProfileResult& result) {
    Json json = Json::object();
    for (const auto& [kind, bytes] : result.bytes)
        json[kind] = bytes;
    return json;
}

Json mapJson(const MeasuredMap& map) {
    Json json = {{"receiver", map.receiver},
                 {"light", map.light},
                 {"size", {map.size.x, map.size.y}},
                 {"planes_drawn", map.planesDrawn}};
    if (map.facing > 0) json["facing"] = map.facing;
    return json;
}

Json resultJson(const ProfileResult& result) {
    Json json = {{"profile", result.profile},
                 {"scene", result.scene},
                 {"receiver", result.receiver},
                 {"method", result.method},
                 {"fill", result.fill},
                 {"planes", result.planes},
                 {"map_size", result.mapSize},
                 {"grid", {result.grid.x, result.grid.y}},
                 {"wall_ms", spreadJson(result.wall)},
                 {"caustics_ms", spreadJson(result.caustics)},
                 {"gpu_ms", passesJson(result)},
                 {"gpu_bytes", bytesJson(result)},
                 {"planes_drawn", result.planesDrawn},
                 {"beams_drawn", result.beamsDrawn},
                 {"skipped", Json::object()}};
    for (const auto& [kind, count] : result.skipped)
        json["skipped"][kind] = count;
    json["maps"] = Json::array();
    for (const MeasuredMap& map : result.maps)
        json["maps"].push_back(mapJson(map));
    if (result.error) json["error"] = errorJson(*result.error);
    if (result.standardError) json["error"]["standard_error"] = *result.standardError;
    if (result.difference) json["difference"] = errorJson(*result.difference);
    return json;
}

Json godrayJson(const GodrayResult& result) {
    const GodraySettings& settings = result.settings;
    Json json = {{"profile", result.profile},
                 {"scene", result.scene},
                 {"method", godrayMethodName(settings.method)},
                 {"grid", {settings.grid.x * settings.subdivision, settings.grid.y * settings.subdivision}},
                 {"scale", settings.scale},
                 {"planes", settings.planes},
                 {"steps", settings.steps},
                 {"sub_volumes", settings.subVolumes},
                 {"godrays_ms", spreadJson(result.ms)},
                 {"gpu_bytes", result.bytes}};
    if (result.error) json["error"] = errorJson(*result.error);
    if (result.standardError) json["error"]["standard_error"] = *result.standardError;
    return json;
}

Json profileJson(const io::Profile& profile) {
    Json json = {{"name", profile.name},
                 {"warmup", profile.warmup},
                 {"frames", profile.frames},
                 {"reuse", profile.reuse},
                 {"reference", profile.reference},
                 {"time", profile.time},
                 {"picture", {profile.picture.x, profile.picture.y}}};
    if (profile.baseline) json["baseline"] = methodName(*profile.baseline);
    json["set"] = Json::array();
    for (const io::Override& setting : profile.settings)
        json["set"].push_back(fmt::format("{}={}", setting.key, setting.value));
    return json;
}

/// A number as CSV has it: empty where there is none.
std::string cell(double value) {
    return std::isfinite(value) ? fmt::format("{:.6g}", value) : "";
}

struct Column {
    std::string name;
    std::function<std::string(const ProfileResult&)> text;
};

template <typename List>
void addNames(std::vector<std::string>& names, const List& entries) {
    for (const auto& [name, value] : entries)
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

template <typename List>
std::string valueOf(const List& entries, const std::string& name) {
    for (const auto& [known, value] : entries)
        if (known == name) return fmt::format("{:.10g}", double(value));
    return "";
}

using Errors = std::optional<ImageErrors> ProfileResult::*;

void addErrorColumns(std::vector<Column>& columns, const std::string& name, Errors errors) {
    const std::pair<const char*, double ImageErrors::*> figures[] = {
        {"nmae", &ImageErrors::nmae},       {"nrmse", &ImageErrors::nrmse},
        {"relmse", &ImageErrors::relmse},   {"luv", &ImageErrors::luv},
        {"psnr", &ImageErrors::psnr},       {"flux_ratio", &ImageErrors::fluxRatio},
        {"largest", &ImageErrors::largest},
    };
    for (const auto& [figure, member] : figures)
        columns.push_back(
            {fmt::format("{}:{}", name, figure), [errors, member = member](const ProfileResult& r) {
                 return r.*errors ? cell((*(r.*errors)).*member) : std::string();
             }});
}

std::vector<Column> columnsOf(const ProfileOutcome& outcome) {
    using R = const ProfileResult&;
    std::vector<Column> columns{
        {"profile", [](R r) { return r.profile; }},
        {"scene", [](R r) { return r.scene; }},
        {"receiver", [](R r) { return r.receiver; }},
        {"method", [](R r) { return r.method; }},
        {"fill", [](R r) { return r.fill; }},
        {"planes", [](R r) { return std::to_string(r.planes); }},
        {"map_size", [](R r) { return std::to_string(r.mapSize); }},
        {"grid_x", [](R r) { return std::to_string(r.grid.x); }},
        {"grid_y", [](R r) { return std::to_string(r.grid.y); }},
        {"wall_ms:min", [](R r) { return cell(r.wall.min); }},
        {"wall_ms:median", [](R r) { return cell(r.wall.median); }},
        {"wall_ms:p95", [](R r) { return cell(r.wall.p95); }},
        {"caustics_ms:min", [](R r) { return cell(r.caustics.min); }},
        {"caustics_ms:median", [](R r) { return cell(r.caustics.median); }},
        {"caustics_ms:p95", [](R r) { return cell(r.caustics.p95); }},
        {"planes_drawn", [](R r) { return std::to_string(r.planesDrawn); }},
        {"beams_drawn", [](R r) { return std::to_string(r.beamsDrawn); }},
    };
    std::vector<std::string> skipped, passes, kinds;
    bool errors = false, differences = false;
    for (const ProfileResult& result : outcome.results) {
        addNames(skipped, result.skipped);
        addNames(passes, result.gpu);
        addNames(kinds, result.bytes);
        errors |= result.error.has_value();
        differences |= result.difference.has_value();
    }
    for (const std::string& name : skipped)
        columns.push_back(
            {fmt::format("skipped:{}", name), [name](R r) { return valueOf(r.skipped, name); }});
    for (const std::string& name : passes)
        columns.push_back({fmt::format("gpu_ms:{}", name), [name](R r) { return valueOf(r.gpu, name); }});
    for (const std::string& name : kinds)
        columns.push_back(
            {fmt::format("gpu_bytes:{}", name), [name](R r) { return valueOf(r.bytes, name); }});
    if (errors) addErrorColumns(columns, "error", &ProfileResult::error);
    if (differences) addErrorColumns(columns, "difference", &ProfileResult::difference);
    return columns;
}

std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string doubled;
    for (const char c : text)
        doubled.append(c == '"' ? 2 : 1, c);
    return fmt::format("\"{}\"", doubled);
}

/// One entry a line: files that are compared and kept under version control.
std::string listText(const Json& list) {
    std::vector<std::string> lines;
    for (const Json& entry : list)
        lines.push_back("  " + entry.dump(-1, ' ', false, Json::error_handler_t::replace));
    return fmt::format("[\n{}\n ]", fmt::join(lines, ",\n"));
}

std::int64_t bytesOf(const ProfileResult& result, std::string_view kind) {
    for (const auto& [known, bytes] : result.bytes)
        if (known == kind) return bytes;
    return 0;
}

} // namespace

std::string resultsJson(const std::vector<io::Profile>& profiles, const ProfileOutcome& outcome,
                        const Machine& machine) {
    Json head = {{"limpid", LIMPID_VERSION},
                 {"commit", builtCommit()},
                 {"build", LIMPID_BUILD_TYPE},
                 {"date", dateNow()},
                 {"machine",
                  {{"cpu", machine.cpu},
                   {"cores", machine.cores},
                   {"gpu", machine.gpu},
                   {"driver", machine.driver},
                   {"gl", machine.gl}}}};
    Json runs = Json::array(), results = Json::array(), histograms = Json::array(), godrays = Json::array();
    for (const io::Profile& profile : profiles)
        runs.push_back(profileJson(profile));
    for (const ProfileResult& result : outcome.results)
        results.push_back(resultJson(result));
    for (const DepthHistogram& histogram : outcome.histograms)
        histograms.push_back({{"profile", histogram.profile},
                              {"scene", histogram.scene},
                              {"receiver", histogram.receiver},
                              {"texels", histogram.texels}});
    for (const GodrayResult& result : outcome.godrays)
        godrays.push_back(godrayJson(result));
    std::string text = head.dump(1, ' ', false, Json::error_handler_t::replace);
    text.erase(text.rfind('\n')); // the closing brace goes last
    return fmt::format(
        "{},\n \"profiles\": {},\n \"results\": {},\n \"depth_histograms\": {},\n \"godrays\": "
        "{}\n}}\n",
        text, listText(runs), listText(results), listText(histograms), listText(godrays));
}

std::string resultsCsv(const ProfileOutcome& outcome) {
    const std::vector<Column> columns = columnsOf(outcome);
    const auto line = [&](auto&& text) {
        std::vector<std::string> cells;
        for (const Column& column : columns)
            cells.push_back(quoted(text(column)));
        return fmt::format("{}\n", fmt::join(cells, ","));
    };
    std::string csv = line([](const Column& column) { return column.name; });
    for (const ProfileResult& result : outcome.results)
        csv += line([&](const Column& column) { return column.text(result); });
    return csv;
}

void printResults(const ProfileOutcome& outcome, const Machine& machine) {
    std::size_t scene = 5, receiver = 8, method = 6, fill = 4;
    for (const ProfileResult& r : outcome.results) {
        scene = std::max(scene, r.scene.size());
        receiver = std::max(receiver, r.receiver.size());
        method = std::max(method, r.method.size());
        fill = std::max(fill, r.fill.size());
    }
    fmt::print("{}, {} cores; {}\n", machine.cpu, machine.cores, machine.gpu);
    if (!outcome.godrays.empty()) printGodrays(outcome.godrays);
    if (outcome.results.empty()) return;
    fmt::print("{:<{}} {:<{}} {:<{}} {:<{}} {:>6} {:>5} {:>9} {:>5} {:>11} {:>10} {:>8} {:>8} {:>8} {:>10}\n",
               "scene", scene, "receiver", receiver, "method", method, "fill", fill, "planes", "map", "grid",
               "drawn", "caustics ms", "frame ms", "MiB", "nMAE", "Luv", "flux ratio");
    for (const ProfileResult& r : outcome.results) {
        fmt::print("{:<{}} {:<{}} {:<{}} {:<{}} {:>6} {:>5} {:>9} {:>5} {:>11.2f} {:>10.2f} {:>8.2f}",
                   r.scene, scene, r.receiver, receiver, r.method, method, r.fill, fill, r.planes, r.mapSize,
                   fmt::format("{}x{}", r.grid.x, r.grid.y), r.planesDrawn, r.caustics.median, r.wall.median,
                   double(bytesOf(r, "peak")) / (1 << 20));
        if (r.error)
            fmt::print(" {:>8.4f} {:>8.3f} {:>10.5f}", r.error->nmae, r.error->luv, r.error->fluxRatio);
        fmt::print("\n");
    }
}

} // namespace limpid::apps
