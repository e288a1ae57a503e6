#include "scene/Shapes.h"

#include <cmath>
#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/Scene.h"

namespace limpid {
namespace {

struct ShapeCase {
    std::string name;
    Mesh mesh;
    std::size_t triangles;
    std::size_t vertices;
    glm::dvec3 size;
};

std::ostream& operator<<(std::ostream& out, const ShapeCase& shape) {
    return out << shape.name;
}

constexpr glm::vec3 albedo(0.1f, 0.5f, 0.9f);

const ShapeCase shapes[] = {
    {"plane", makePlane({2, 3}, albedo), 2, 4, {2, 0, 3}},
    {"sphere", makeSphere(0.5, albedo), 1984, 33 * 33, {1, 1, 1}},
    {"fine sphere", makeSphere(0.5, albedo, 64), 2 * 64 * 63, 65 * 65, {1, 1, 1}},
    {"coarse sphere", makeSphere(0.5, albedo, 8), 2 * 8 * 7, 81, {1, 1, 1}},
    {"box", makeBox({1, 2, 3}, albedo), 12, 24, {1, 2, 3}},
    {"tiny box", makeBox({1e-9, 1e-9, 1e-9}, albedo), 12, 24, {1e-9, 1e-9, 1e-9}},
    {"huge sphere", makeSphere(1e9, albedo), 1984, 33 * 33, {2e9, 2e9, 2e9}},
};

class ShapesTest : public testing::TestWithParam<ShapeCase> {
  protected:
    const Mesh& mesh = GetParam().mesh;

    glm::dvec3 corner(std::size_t index) const { return mesh.positions[mesh.indices[index]]; }
};

TEST_P(ShapesTest, HasItsCountsSizeAndMaterial) {
    EXPECT_EQ(mesh.triangleCount(), GetParam().triangles);
    EXPECT_EQ(mesh.positions.size(), GetParam().vertices);
    EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
    EXPECT_EQ(mesh.uvs.size(), mesh.positions.size());
    Bounds bounds;
    for (const glm::dvec3& p : mesh.positions)
        bounds.add(p);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_DOUBLE_EQ(bounds.size()[axis], GetParam().size[axis]);
        EXPECT_DOUBLE_EQ(bounds.center()[axis], 0);
    }
    ASSERT_EQ(mesh.parts.size(), 1u);
    EXPECT_EQ(mesh.parts[0].indexCount, mesh.indices.size());
    ASSERT_EQ(mesh.materials.size(), 1u);
    EXPECT_EQ(mesh.materials[0].baseColor, glm::vec4(albedo, 1));
    EXPECT_EQ(mesh.materials[0].baseColorImage, -1);
}

TEST_P(ShapesTest, TrianglesFaceTheWayTheirNormalsPointAndAreNotDegenerate) {
    const double unitArea = std::pow(glm::length(GetParam().size), 2);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::dvec3 face = glm::cross(corner(i + 1) - corner(i), corner(i + 2) - corner(i));
        ASSERT_GT(glm::length(face), 1e-5 * unitArea) << "triangle " << i / 3;
        for (std::size_t c = 0; c < 3; ++c) {
            const glm::dvec3 normal(mesh.normals[mesh.indices[i + c]]);
            EXPECT_GT(glm::dot(glm::normalize(face), normal), 0.9) << "triangle " << i / 3;
            EXPECT_NEAR(glm::length(normal), 1, 1e-6);
        }
    }
}

/// The signed volume under all triangles is the solid's own if and only if the surface is closed and faces
/// outward.
TEST(SolidsTest, EncloseTheirVolume) {
    const auto volume = [](const Mesh& mesh) {
        double sum = 0;
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
            sum +=
                glm::dot(mesh.positions[mesh.indices[i]], glm::cross(mesh.positions[mesh.indices[i + 1]],
                                                                     mesh.positions[mesh.indices[i + 2]])) /
                6;
        return sum;
    };
    EXPECT_NEAR(volume(makeBox({1, 2, 3}, albedo)), 6, 1e-12);
    // 32 slices and stacks stay about 1 % inside of the sphere that they are inscribed in.
    const double sphere = 4.0 / 3 * std::numbers::pi;
    EXPECT_NEAR(volume(makeSphere(1, albedo)) / sphere, 0.99, 0.005);
    // The share that is missing goes by the square of the segments.
    EXPECT_NEAR((1 - volume(makeSphere(1, albedo, 128)) / sphere) /
                    (1 - volume(makeSphere(1, albedo)) / sphere),
                1.0 / 16, 1e-3);
}

TEST(PlaneTest, FacesUpWithTextureRowsFromTheBack) {
    const Mesh plane = makePlane({2, 2}, albedo);
    for (std::size_t i = 0; i < plane.positions.size(); ++i) {
        EXPECT_EQ(plane.normals[i], glm::vec3(0, 1, 0));
        EXPECT_EQ(plane.uvs[i], glm::vec2(0.5 + plane.positions[i].x / 2, 0.5 + plane.positions[i].z / 2));
    }
}

TEST(SphereTest, NormalsAreRadii) {
    const Mesh sphere = makeSphere(2, albedo);
    for (std::size_t i = 0; i < sphere.positions.size(); ++i) {
        EXPECT_NEAR(glm::length(sphere.positions[i]), 2, 1e-12);
        EXPECT_NEAR(glm::length(sphere.positions[i] / 2.0 - glm::dvec3(sphere.normals[i])), 0, 1e-6);
    }
}

INSTANTIATE_TEST_SUITE_P(All, ShapesTest, testing::ValuesIn(shapes));

} // namespace
} // namespace limpid
