#pragma once
#include <cstdint>
#include <functional>
#include <initializer_list>

#include "scene/Mesh.h"

namespace limpid::test {

enum BuilderMaterial { Opaque, Clear };

/// A mesh of sheets and boxes, some of them clear.
struct MeshBuilder {
    Mesh mesh;

    MeshBuilder() {
        mesh.materials.resize(2);
        mesh.materials[Clear].alphaMode = AlphaMode::Blend;
        mesh.materials[Clear].baseColor.a = 0.3f;
    }
    MeshBuilder& quad(std::initializer_list<glm::dvec3> corners, BuilderMaterial material = Opaque) {
        const auto first = std::uint32_t(mesh.positions.size());
        mesh.positions.insert(mesh.positions.end(), corners);
        mesh.parts.push_back({std::uint32_t(mesh.indices.size()), 6, material});
        for (const std::uint32_t i : {0, 1, 2, 0, 2, 3})
            mesh.indices.push_back(first + i);
        return *this;
    }
    /// A level sheet.
    MeshBuilder& sheet(const glm::dvec2& low, const glm::dvec2& high, double y,
                       BuilderMaterial material = Opaque) {
        return quad({{low.x, y, low.y}, {low.x, y, high.y}, {high.x, y, high.y}, {high.x, y, low.y}},
                    material);
    }
    /// An upright sheet.
    MeshBuilder& wall(const glm::dvec2& from, const glm::dvec2& to, double low, double high,
                      BuilderMaterial material = Opaque) {
        return quad({{from.x, low, from.y}, {to.x, low, to.y}, {to.x, high, to.y}, {from.x, high, from.y}},
                    material);
    }
    MeshBuilder& walls(const glm::dvec2& low, const glm::dvec2& high, double bottom, double top,
                       BuilderMaterial material = Opaque) {
        return wall(low, {high.x, low.y}, bottom, top, material)
            .wall({high.x, low.y}, high, bottom, top, material)
            .wall(high, {low.x, high.y}, bottom, top, material)
            .wall({low.x, high.y}, low, bottom, top, material);
    }
    MeshBuilder& box(const glm::dvec3& low, const glm::dvec3& high, BuilderMaterial material = Opaque) {
        return walls({low.x, low.z}, {high.x, high.z}, low.y, high.y, material)
            .sheet({low.x, low.z}, {high.x, high.z}, low.y, material)
            .sheet({low.x, low.z}, {high.x, high.z}, high.y, material);
    }
    /// 4 x 2 m, 1.2 m deep.
    MeshBuilder& pool() { return sheet({-2, -1}, {2, 1}, -1.2).walls({-2, -1}, {2, 1}, -1.2, 0); }
    /// Ground of 60² quads over [-1, 1]², `height` of each corner.
    MeshBuilder& ground(const std::function<double(double, double)>& height) {
        constexpr int side = 60;
        const auto at = [&](int i, int k) {
            const double x = 2.0 * i / side - 1, z = 2.0 * k / side - 1;
            return glm::dvec3(x, height(x, z), z);
        };
        for (int i = 0; i < side; ++i)
            for (int k = 0; k < side; ++k)
                quad({at(i, k), at(i, k + 1), at(i + 1, k + 1), at(i + 1, k)});
        return *this;
    }
};

} // namespace limpid::test
