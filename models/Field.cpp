#include "Field.h"

#include "Simplify.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace limpid::models {

namespace {

double smoothMin(double a, double b, double k) {
    const double h = std::max(k - std::abs(a - b), 0.0) / k;
    return std::min(a, b) - 0.25 * k * h * h;
}

glm::dvec3 gradient(const Field& field, const glm::dvec3& p) {
    const double e = 1e-4;
    glm::dvec3 g;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 step{0.0};
        step[axis] = e;
        g[axis] = (field(p + step) - field(p - step)) / (2.0 * e);
    }
    return g;
}

/// Values of the field at the corners of a lattice, and the surface between them.
class Lattice {
  public:
    Lattice(const Field& field, const glm::dvec3& low, const glm::dvec3& high, double cell)
        : _low{low}, _cell{cell}, _count{glm::ceil((high - low) / cell)} {
        for (int z = 0; z <= _count.z; ++z)
            for (int y = 0; y <= _count.y; ++y)
                for (int x = 0; x <= _count.x; ++x)
                    _values.push_back(field(place({x, y, z})));
    }

    Shell surface() {
        for (int z = 0; z < _count.z; ++z)
            for (int y = 0; y < _count.y; ++y)
                for (int x = 0; x < _count.x; ++x)
                    cube({x, y, z});
        return std::move(_shell);
    }

  private:
    using Corner = std::uint32_t;

    glm::dvec3 place(const glm::ivec3& c) const { return _low + _cell * glm::dvec3{c}; }

    Corner corner(const glm::ivec3& c) const {
        return static_cast<Corner>((c.z * (_count.y + 1) + c.y) * (_count.x + 1) + c.x);
    }

    glm::dvec3 place(Corner c) const {
        const auto nx = static_cast<Corner>(_count.x + 1), ny = static_cast<Corner>(_count.y + 1);
        return place(glm::ivec3(int(c % nx), int(c / nx % ny), int(c / nx / ny)));
    }

    // Six tetrahedra around the diagonal; neighbours cut their common face alike.
    void cube(const glm::ivec3& c) {
        static constexpr int orders[6][2]{{0, 1}, {1, 2}, {2, 0}, {1, 0}, {2, 1}, {0, 2}};
        for (const auto& [first, second] : orders) {
            std::array<Corner, 4> t{corner(c), 0, 0, corner(c + 1)};
            glm::ivec3 step{0};
            step[first] = 1;
            t[1] = corner(c + step);
            step[second] = 1;
            t[2] = corner(c + step);
            tetrahedron(t);
        }
    }

    void tetrahedron(std::array<Corner, 4> t) {
        const auto outer =
            std::stable_partition(t.begin(), t.end(), [&](Corner c) { return _values[c] < 0.0; });
        const auto inner = outer - t.begin();
        if (inner == 0 || inner == 4) return;
        const glm::dvec3 out = place(t[3]) - place(t[0]);
        if (inner == 2) {
            const auto a = edge(t[0], t[2]), b = edge(t[0], t[3]), c = edge(t[1], t[3]), d = edge(t[1], t[2]);
            triangle(a, b, c, out);
            triangle(a, c, d, out);
        } else {
            // One after the other, in the order of the committed models: a new edge is a new vertex.
            const Corner alone = inner == 1 ? t[0] : t[3];
            const auto others = inner == 1 ? t.begin() + 1 : t.begin();
            const auto c = edge(alone, others[2]), b = edge(alone, others[1]), a = edge(alone, others[0]);
            triangle(a, b, c, out);
        }
    }

    // The triangle's plane parts the inner from the outer corners; `out` leads from one to one.
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, const glm::dvec3& out) {
        const auto& p = _shell.positions;
        if (glm::dot(glm::cross(p[b] - p[a], p[c] - p[a]), out) < 0.0) std::swap(b, c);
        _shell.indices.insert(_shell.indices.end(), {a, b, c});
    }

    // Kept away from the corners, where triangles would have no area.
    std::uint32_t edge(Corner a, Corner b) {
        const auto key = std::minmax(a, b);
        const auto [found, added] =
            _edges.try_emplace({key.first, key.second}, static_cast<std::uint32_t>(_shell.positions.size()));
        if (added) {
            const double va = _values[key.first], vb = _values[key.second];
            const double t = std::clamp(va / (va - vb), 0.1, 0.9);
            _shell.positions.push_back(glm::mix(place(key.first), place(key.second), t));
        }
        return found->second;
    }

    glm::dvec3 _low;
    double _cell;
    glm::ivec3 _count;
    std::vector<double> _values;
    std::map<std::pair<Corner, Corner>, std::uint32_t> _edges;
    Shell _shell;
};

// Every vertex half-way to the mean of its neighbours.
void relax(Shell& shell) {
    std::vector<glm::dvec3> sums(shell.positions.size(), glm::dvec3{0.0});
    std::vector<double> counts(shell.positions.size(), 0.0);
    for (std::size_t i = 0; i < shell.indices.size(); ++i) {
        const std::uint32_t here = shell.indices[i], next = shell.indices[i % 3 == 2 ? i - 2 : i + 1];
        sums[here] += shell.positions[next];
        counts[here] += 1.0;
    }
    for (std::size_t i = 0; i < sums.size(); ++i)
        shell.positions[i] = 0.5 * (shell.positions[i] + sums[i] / counts[i]);
}

} // namespace

Field roundCone(const glm::dvec3& a, double radiusA, const glm::dvec3& b, double radiusB) {
    return [=](const glm::dvec3& p) {
        const glm::dvec3 axis = b - a;
        const double t = std::clamp(glm::dot(p - a, axis) / glm::dot(axis, axis), 0.0, 1.0);
        return glm::distance(p, a + t * axis) - glm::mix(radiusA, radiusB, t);
    };
}

Field ellipsoid(const glm::dvec3& centre, const glm::dvec3& radii) {
    return [=](const glm::dvec3& p) {
        const glm::dvec3 q = (p - centre) / radii;
        const double slope = glm::length(q / radii);
        const double r = glm::length(q);
        return slope > 0.0 ? r * (r - 1.0) / slope : -std::min({radii.x, radii.y, radii.z});
    };
}

Field joined(std::vector<Field> fields, double blend) {
    return [fields = std::move(fields), blend](const glm::dvec3& p) {
        double d = 1e9;
        for (const Field& field : fields)
            d = smoothMin(d, field(p), blend);
        return d;
    };
}

Field cut(Field from, Field what, double blend) {
    return [from = std::move(from), what = std::move(what), blend](const glm::dvec3& p) {
        return -smoothMin(-from(p), what(p), blend);
    };
}

Shell surfaceOf(const Field& field, const glm::dvec3& low, const glm::dvec3& high, double cell,
                std::size_t triangles) {
    Shell shell = Lattice{field, low, high, cell}.surface();
    const auto drawn = [&](glm::dvec3 p) {
        for (int i = 0; i < 3; ++i) {
            const glm::dvec3 g = gradient(field, p);
            const double steep = glm::dot(g, g);
            if (steep > 1e-6) p -= glm::clamp(field(p) / steep, -0.3 * cell, 0.3 * cell) * g;
        }
        return p;
    };
    // Marching leaves slivers, which even out while the vertices slide along the surface.
    for (int i = 0; i < 4; ++i) {
        relax(shell);
        for (glm::dvec3& p : shell.positions)
            p = drawn(p);
    }
    return simplified(shell, triangles);
}

} // namespace limpid::models
