#include "io/bake/BakedFolder.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/Error.h"
#include "io/Files.h"
#include "io/images/Images.h"

namespace limpid::io {

namespace {

using Json = nlohmann::ordered_json;

Json fluxJson(const BakedFlux& flux) {
    Json json = {{"entering", flux.entering},   {"absorbed", flux.absorbed}, {"scattered", flux.scattered},
                 {"deposited", flux.deposited}, {"missed", flux.missed},     {"rejected", flux.rejected},
                 {"residual", flux.residual}};
    if (flux.standardError) json["standard_error"] = *flux.standardError;
    return json;
}

Json lightJson(const BakedLight& light) {
    Json json = {{"light", light.light}, {"beams", light.beams}, {"beams_drawn", light.beamsDrawn}};
    if (light.flux) json["flux"] = fluxJson(*light.flux);
    return json;
}

std::string fileName(const BakedMap& map, const char* what) {
    if (map.facing > 0)
        return fmt::format("{}.{}.facing{}.{}.exr", map.receiver, map.light, map.facing, what);
    return fmt::format("{}.{}.{}.exr", map.receiver, map.light, what);
}

Json mapJson(const BakedMap& map) {
    Json matrix = Json::array();
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            matrix.push_back(map.worldToTexture[column][row]);
    Json json = {{"receiver", map.receiver},
                 {"light", map.light},
                 {"size", {map.size.x, map.size.y}},
                 {"irradiance", fileName(map, "irradiance")},
                 {"position", fileName(map, "position")},
                 {"normal", fileName(map, "normal")},
                 {"world_to_texture", matrix},
                 {"planes", {{"requested", map.planesRequested}, {"drawn", map.planesDrawn}}},
                 {"flux", {{"deposited", map.deposited}}}};
    // Only a side map says so: see "A baked folder" in docs/start.md.
    if (map.facing > 0) json["facing"] = map.facing;
    if (map.standardError) json["standard_error"] = *map.standardError;
    return json;
}

} // namespace

void prepareFolder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (!std::filesystem::is_directory(folder))
        throw InputError(fmt::format("{}: expected a folder to write to, found {}", folder.string(),
                                     std::filesystem::exists(folder) ? "a file" : error.message()));
}

void writeBake(const std::filesystem::path& folder, const Bake& bake) {
    prepareFolder(folder);
    StagedFolder staged(folder);
    Json index = {{"limpid", LIMPID_VERSION}, {"device", bake.device},
                  {"input", bake.input},      {"method", bake.method},
                  {"time", bake.time},        {"origin", {bake.origin.x, bake.origin.y, bake.origin.z}}};
    index["lights"] = Json::array();
    index["maps"] = Json::array();
    for (const BakedLight& light : bake.lights)
        index["lights"].push_back(lightJson(light));
    for (const BakedMap& map : bake.maps) {
        writeExr(staged.path() / fileName(map, "irradiance"), map.size.x, map.size.y, {"R", "G", "B"},
                 map.irradiance);
        writeExr(staged.path() / fileName(map, "position"), map.size.x, map.size.y, {"R", "G", "B", "A"},
                 map.position);
        writeExr(staged.path() / fileName(map, "normal"), map.size.x, map.size.y, {"R", "G", "B"},
                 map.normal);
        index["maps"].push_back(mapJson(map));
    }
    writeText(staged.path() / "index.json", index.dump(2) + "\n");
    staged.appear("index.json");
}

} // namespace limpid::io
