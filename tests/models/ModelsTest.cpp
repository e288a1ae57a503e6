// The committed models are what the generator writes, and they are sound: right counts, closed where the
// README says so, one metre long, standing on y = 0.

#include "Folders.h"
#include "io/gltf/Gltf.h"
#include "plan/Facings.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <numeric>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

struct ModelCase {
    std::string name;
    std::size_t triangles;
    bool closed;
    double thesis; ///< polygons of the thesis's receiver of that name (Tipprasert 2006, appendix); 0: there
                   ///< is none
};

void PrintTo(const ModelCase& model, std::ostream* stream) {
    *stream << model.name;
}

const ModelCase models[] = {
    {"teapot", 6320, false, 6320}, // the pot is open under its lid, as Newell made it
    {"sphere", 1984, true, 1984},
    {"box", 12, true, 12},
    {"cross", 76, true, 76},
    {"fish", 2964, true, 0},
    {"dolphin", 4280, true, 4442},
    // The thesis's others.
    {"angle_fish", 7320, true, 6996},
    {"red_betta", 6768, true, 6760},
    {"siamese_tiger", 7008, true, 6822},
    {"barramundi", 6584, true, 6524},
    {"brown_trout", 7040, true, 6828},
    {"lion_head", 7032, true, 6602},
    {"steel_head", 7488, true, 7226},
    {"bass", 2556, true, 2253},
    {"shark", 1032, true, 942},
    {"leopard_shark", 5424, true, 5200},
    {"sand_bar_shark", 5480, true, 5200},
    {"whale", 7040, true, 6288},
    {"manta", 6992, true, 6820},
    {"sun_fish", 5176, true, 4912},
    {"horse", 4616, true, 4314},
    {"hammer", 12884, true, 13478},
    {"car", 10528, true, 9907},
    {"chair", 188, true, 190},
    {"sink", 948, true, 1068},
    {"sofa", 9808, true, 10360},
    {"ufo", 21704, true, 20663},
    {"plane", 3008, true, 3030},
    {"helicopter", 4680, true, 5138},
    {"camera", 13684, true, 15496},
    {"tank", 26808, true, 25812},
};

fs::path committed(const std::string& name) {
    return fs::path{limpid::test::rootFolder()} / "models" / (name + ".glb");
}

std::string contents(const fs::path& path) {
    std::ifstream stream{path, std::ios::binary};
    return {std::istreambuf_iterator<char>{stream}, {}};
}

struct Triangles {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<std::array<std::size_t, 3>> corners;
};

/// A .glb as the generator lays it out: accessors 0 to 2 are 16-bit indices, positions and normals.
class Glb {
  public:
    explicit Glb(const fs::path& path) : _bytes{contents(path)} {
        const auto length = at<std::uint32_t>(12);
        _json = nlohmann::json::parse(_bytes.substr(20, length));
        _binary = 20 + length + 8;
    }

    Triangles triangles() const {
        Triangles result;
        const auto indices = accessor<std::uint16_t>(0);
        for (std::size_t i = 0; i < indices.size(); i += 3)
            result.corners.push_back({indices[i], indices[i + 1], indices[i + 2]});
        result.positions = accessor<glm::vec3>(1);
        result.normals = accessor<glm::vec3>(2);
        return result;
    }

    std::size_t indexCount() const {
        const auto& primitive = _json.at("meshes").at(0).at("primitives").at(0);
        return _json.at("accessors").at(primitive.at("indices").get<std::size_t>()).at("count");
    }

  private:
    template <typename T>
    T at(std::size_t offset) const {
        T value;
        std::memcpy(&value, _bytes.data() + offset, sizeof value);
        return value;
    }

    template <typename T>
    std::vector<T> accessor(std::size_t index) const {
        const auto& description = _json.at("accessors").at(index);
        const auto& view = _json.at("bufferViews").at(description.at("bufferView").get<std::size_t>());
        std::vector<T> values;
        for (std::size_t i = 0; i < description.at("count").get<std::size_t>(); ++i)
            values.push_back(at<T>(_binary + view.at("byteOffset").get<std::size_t>() + i * sizeof(T)));
        return values;
    }

    std::string _bytes;
    nlohmann::json _json;
    std::size_t _binary = 0;
};

class Models : public testing::TestWithParam<ModelCase> {};
class Receivers : public Models {};

TEST_P(Models, areWhatTheGeneratorWrites) {
    const fs::path folder = fs::path{limpid::test::buildFolder()} / "tests" / ("models-" + GetParam().name);
    fs::remove_all(folder);
    const std::string command =
        "\"" + limpid::test::buildFolder() + "/limpid-make-models\" \"" + folder.string() + "\" " + GetParam().name;
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
    const std::string made = contents(folder / (GetParam().name + ".glb"));
    EXPECT_FALSE(made.empty());
    EXPECT_TRUE(made == contents(committed(GetParam().name)))
        << "models/" << GetParam().name << ".glb is stale: run limpid-make-models models";
}

TEST_P(Models, haveTheirNumberOfTriangles) {
    EXPECT_EQ(Glb{committed(GetParam().name)}.indexCount(), 3 * GetParam().triangles);
}

// Within a fifth of the thesis's, so that its run times and memory can stand beside ours.
TEST_P(Receivers, haveAboutTheThesissNumberOfTriangles) {
    EXPECT_NEAR(double(Glb{committed(GetParam().name)}.indexCount()) / 3.0, GetParam().thesis,
                0.2 * GetParam().thesis);
}

TEST_P(Models, areOneMetreLongAndStandOnZero) {
    glm::vec3 min{1e9f};
    glm::vec3 max{-1e9f};
    for (const glm::vec3& position : Glb{committed(GetParam().name)}.triangles().positions) {
        min = glm::min(min, position);
        max = glm::max(max, position);
    }
    const glm::vec3 extent = max - min;
    EXPECT_EQ(std::max({extent.x, extent.y, extent.z}), 1.0f);
    EXPECT_EQ(min.y, 0.0f);
    // Coordinates are rounded to 1e-6 m, so the middle can be off by half of that.
    EXPECT_NEAR(min.x + max.x, 0.0f, 1e-6f);
    EXPECT_NEAR(min.z + max.z, 0.0f, 1e-6f);
}

TEST_P(Models, haveUnitNormalsOnTheSideOfTheirTriangles) {
    const Triangles mesh = Glb{committed(GetParam().name)}.triangles();
    for (const glm::vec3& normal : mesh.normals)
        ASSERT_NEAR(glm::length(normal), 1.0f, 2e-6f); // components are rounded to 1e-6
    for (const auto& corners : mesh.corners) {
        const glm::dvec3 a = mesh.positions[corners[0]];
        const glm::dvec3 b = mesh.positions[corners[1]];
        const glm::dvec3 c = mesh.positions[corners[2]];
        const glm::dvec3 cross = glm::cross(b - a, c - a);
        ASSERT_GT(glm::length(cross), 1e-9) << "a triangle without area";
        for (std::size_t corner : corners)
            ASSERT_GT(glm::dot(glm::normalize(cross), glm::dvec3{mesh.normals[corner]}), 0.0);
    }
}

/// Groups of triangles that hang together: for each triangle, a number that its group shares.
class Parts {
  public:
    explicit Parts(const Triangles& mesh) : _parents(mesh.positions.size()) {
        std::iota(_parents.begin(), _parents.end(), std::size_t{0});
        std::map<std::array<float, 3>, std::size_t> places;
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            const glm::vec3 p = mesh.positions[i];
            join(i, places.try_emplace({p.x, p.y, p.z}, i).first->second);
        }
        for (const auto& [a, b, c] : mesh.corners) {
            join(a, b);
            join(b, c);
        }
    }

    std::size_t of(std::size_t i) {
        while (_parents[i] != i)
            i = _parents[i] = _parents[_parents[i]];
        return i;
    }

  private:
    void join(std::size_t a, std::size_t b) { _parents[of(a)] = of(b); }

    std::vector<std::size_t> _parents;
};

// A closed part that faces inward has a negative volume. An open model is taken as a whole: what it lacks of
// a solid is little.
TEST_P(Models, haveNoPartThatFacesInward) {
    const Triangles mesh = Glb{committed(GetParam().name)}.triangles();
    Parts parts{mesh};
    std::map<std::size_t, double> volumes;
    for (const auto& [a, b, c] : mesh.corners) {
        const glm::dvec3 p = mesh.positions[a], q = mesh.positions[b], r = mesh.positions[c];
        volumes[GetParam().closed ? parts.of(a) : 0] += glm::dot(p, glm::cross(q, r)) / 6.0;
    }
    for (const auto& [part, volume] : volumes)
        EXPECT_GT(volume, 0.0) << "the part around vertex " << part;
}

// Closed: each edge, by position, is used once in either direction.
TEST_P(Models, areClosedWhereTheySaySo) {
    const Triangles mesh = Glb{committed(GetParam().name)}.triangles();
    using Point = std::array<float, 3>;
    const auto point = [&](std::size_t i) {
        return Point{mesh.positions[i].x, mesh.positions[i].y, mesh.positions[i].z};
    };
    std::map<std::pair<Point, Point>, int> uses;
    for (const auto& corner : mesh.corners)
        for (std::size_t i = 0; i < 3; ++i)
            ++uses[{point(corner[i]), point(corner[(i + 1) % 3])}];
    std::size_t open = 0;
    for (const auto& [edge, count] : uses) {
        const auto opposite = uses.find({edge.second, edge.first});
        open += count != 1 || opposite == uses.end();
    }
    EXPECT_EQ(open == 0, GetParam().closed) << open << " open edges";
}

TEST_P(Models, areSolidsForLimpidWhereTheyAreClosed) {
    const limpid::Mesh mesh = limpid::io::loadGltf(committed(GetParam().name));
    EXPECT_EQ(mesh.indices.size(), 3 * GetParam().triangles);
    EXPECT_EQ(limpid::isClosed(mesh), GetParam().closed);
}

std::vector<ModelCase> thesisModels() {
    std::vector<ModelCase> result;
    std::ranges::copy_if(models, std::back_inserter(result), [](const ModelCase& m) { return m.thesis > 0; });
    return result;
}

INSTANTIATE_TEST_SUITE_P(All, Models, testing::ValuesIn(models),
                         [](const auto& test) { return test.param.name; });

INSTANTIATE_TEST_SUITE_P(Thesis, Receivers, testing::ValuesIn(thesisModels()),
                         [](const auto& test) { return test.param.name; });

} // namespace
