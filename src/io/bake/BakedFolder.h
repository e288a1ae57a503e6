#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace limpid::io {

/// The maps of one receiver and light, as they go into a baked folder. Rows from the top of the box.
struct BakedMap {
    std::string receiver, light;
    glm::ivec2 size{0};
    std::vector<float> irradiance; ///< RGB, W/m² on the receiver's own surface
    std::vector<float> position;   ///< RGBA: m relative to the origin; 1 where there is a receiver
    std::vector<float> normal;     ///< RGB: unit, geometric, facing the box's top
    glm::dmat4 worldToTexture{1};
    int facing = 0; ///< 0 the map along the light, else a side map for faces along it
    int planesRequested = 0, planesDrawn = 0;
    double deposited = 0; ///< W
    /// Of `reference`: the nMAE (mean absolute error over the mean) that a perfect map would show against
    /// this one, from the spread of independent estimates. A difference below it is no error.
    std::optional<double> standardError;
};

/// Where what one light sends went, W.
struct BakedFlux {
    double entering = 0, absorbed = 0, scattered = 0, deposited = 0, missed = 0, rejected = 0, residual = 0;
    std::optional<double> standardError; ///< of the residual, where rays at random were counted
};

struct BakedLight {
    std::string light;
    std::int64_t beams = 0, beamsDrawn = 0;
    std::optional<BakedFlux> flux; ///< empty where it was not counted
};

struct Bake {
    std::string device, input, method;
    double time = 0; ///< s
    glm::dvec3 origin{0};
    std::vector<BakedLight> lights;
    std::vector<BakedMap> maps;
};

/// Makes `folder` if need be, so that a long computation does not end at a wrong name. Throws InputError.
void prepareFolder(const std::filesystem::path& folder);

/// Writes `index.json` and the EXR files of every map into `folder`, which is made if need be; the index
/// comes last, so that a folder with an index is whole. Throws InputError when it cannot be written, and then
/// leaves what stood there.
void writeBake(const std::filesystem::path& folder, const Bake& bake);

/// Reads a whole baked folder. Throws InputError: file, place in it, expected, found.
Bake readBake(const std::filesystem::path& folder);

} // namespace limpid::io
