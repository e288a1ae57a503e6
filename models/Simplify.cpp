#include "Simplify.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <queue>
#include <tuple>

namespace limpid::models {

namespace {

using Vertex = std::uint32_t;
using Triangle = std::array<Vertex, 3>;

/// The squared distances to planes, weighted by area: pᵀ A p − 2 b·p + c.
struct Quadric {
    glm::dmat3 A{0.0};
    glm::dvec3 b{0.0};
    double c = 0.0;

    void addPlane(const glm::dvec3& normal, const glm::dvec3& point, double weight) {
        const double d = glm::dot(normal, point);
        A += weight * glm::outerProduct(normal, normal);
        b += weight * d * normal;
        c += weight * d * d;
    }

    Quadric& operator+=(const Quadric& other) {
        A += other.A;
        b += other.b;
        c += other.c;
        return *this;
    }

    double at(const glm::dvec3& p) const { return glm::dot(p, A * p) - 2.0 * glm::dot(b, p) + c; }
};

/// An edge that may go, with its vertices' versions at the time: it is void once either has changed.
struct Candidate {
    double cost;
    Vertex a, b;
    unsigned versionA, versionB;
    glm::dvec3 place;

    bool operator<(const Candidate& other) const { // the cheapest is on top of the queue
        return std::tie(cost, a, b) > std::tie(other.cost, other.a, other.b);
    }
};

// 1 for equal sides, 0 for a sliver.
double quality(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 ab = b - a, bc = c - b, ca = a - c;
    const double sides = glm::dot(ab, ab) + glm::dot(bc, bc) + glm::dot(ca, ca);
    return 2.0 * std::sqrt(3.0) * glm::length(glm::cross(ab, ca)) / sides;
}

class Simplifier {
  public:
    explicit Simplifier(const Shell& shell)
        : _places{shell.positions}, _around(_places.size()), _quadrics(_places.size()),
          _versions(_places.size()) {
        for (std::size_t i = 0; i < shell.indices.size(); i += 3)
            addTriangle({shell.indices[i], shell.indices[i + 1], shell.indices[i + 2]});
        for (const Triangle& t : _triangles)
            for (std::size_t corner = 0; corner < 3; ++corner)
                if (t[corner] < t[(corner + 1) % 3]) offer(t[corner], t[(corner + 1) % 3]);
    }

    void reduceTo(std::size_t triangles) {
        while (_alive > triangles && !_queue.empty()) {
            const Candidate candidate = _queue.top();
            _queue.pop();
            const bool current =
                _versions[candidate.a] == candidate.versionA && _versions[candidate.b] == candidate.versionB;
            if (current && mayCollapse(candidate)) collapse(candidate);
        }
    }

    Shell shell() const {
        Shell result;
        std::map<Vertex, Vertex> known;
        for (const Triangle& t : _triangles) {
            if (t[0] == t[1]) continue;
            for (Vertex v : t) {
                const auto [found, added] =
                    known.try_emplace(v, static_cast<Vertex>(result.positions.size()));
                if (added) result.positions.push_back(_places[v]);
                result.indices.push_back(found->second);
            }
        }
        return result;
    }

  private:
    void addTriangle(const Triangle& t) {
        const glm::dvec3 a = _places[t[0]];
        const glm::dvec3 across = glm::cross(_places[t[1]] - a, _places[t[2]] - a);
        const double doubleArea = glm::length(across);
        for (Vertex v : t) {
            _around[v].push_back(_triangles.size());
            if (doubleArea > 0.0) _quadrics[v].addPlane(across / doubleArea, a, 0.5 * doubleArea);
        }
        _triangles.push_back(t);
        ++_alive;
    }

    std::vector<Vertex> neighbours(Vertex v) const {
        std::vector<Vertex> result;
        for (std::size_t t : _around[v])
            for (Vertex other : _triangles[t])
                if (other != v) result.push_back(other);
        std::sort(result.begin(), result.end());
        result.erase(std::unique(result.begin(), result.end()), result.end());
        return result;
    }

    void offer(Vertex a, Vertex b) {
        Quadric sum = _quadrics[a];
        sum += _quadrics[b];
        const std::array<glm::dvec3, 3> places{_places[a], _places[b], 0.5 * (_places[a] + _places[b])};
        const auto best = std::min_element(places.begin(), places.end(), [&](const auto& p, const auto& q) {
            return sum.at(p) < sum.at(q);
        });
        // Where all is flat, short edges go first.
        const double length = glm::distance(_places[a], _places[b]);
        const double cost = std::max(sum.at(*best), 0.0) + 1e-3 * std::pow(length, 4.0);
        _queue.push({cost, a, b, _versions[a], _versions[b], *best});
    }

    // Two vertices with more than two common neighbours would leave a fold behind.
    bool mayCollapse(const Candidate& c) const {
        const std::vector<Vertex> ofA = neighbours(c.a), ofB = neighbours(c.b);
        std::vector<Vertex> common;
        std::set_intersection(ofA.begin(), ofA.end(), ofB.begin(), ofB.end(), std::back_inserter(common));
        return common.size() == 2 && ofA.size() + ofB.size() > 8 && keepsShape(c.a, c.b, c.place) &&
               keepsShape(c.b, c.a, c.place);
    }

    // Whether the triangles around `moving` that stay keep their side and do not become slivers.
    bool keepsShape(Vertex moving, Vertex other, const glm::dvec3& place) const {
        for (std::size_t t : _around[moving]) {
            const Triangle& triangle = _triangles[t];
            if (std::find(triangle.begin(), triangle.end(), other) != triangle.end()) continue;
            std::array<glm::dvec3, 3> before, after;
            for (std::size_t i = 0; i < 3; ++i) {
                before[i] = _places[triangle[i]];
                after[i] = triangle[i] == moving ? place : before[i];
            }
            const glm::dvec3 was = glm::cross(before[1] - before[0], before[2] - before[0]);
            const glm::dvec3 is = glm::cross(after[1] - after[0], after[2] - after[0]);
            if (glm::dot(was, is) <= 0.3 * glm::length(was) * glm::length(is)) return false;
            const double good = quality(after[0], after[1], after[2]);
            if (good < 0.15 && good < quality(before[0], before[1], before[2])) return false;
        }
        return true;
    }

    void collapse(const Candidate& c) {
        _places[c.a] = c.place;
        _quadrics[c.a] += _quadrics[c.b];
        for (std::size_t t : _around[c.b]) {
            Triangle& triangle = _triangles[t];
            if (std::find(triangle.begin(), triangle.end(), c.a) != triangle.end()) {
                for (Vertex v : triangle)
                    if (v != c.b) std::erase(_around[v], t);
                triangle = {0, 0, 0};
                --_alive;
            } else {
                std::replace(triangle.begin(), triangle.end(), c.b, c.a);
                _around[c.a].push_back(t);
            }
        }
        _around[c.b].clear();
        ++_versions[c.a];
        ++_versions[c.b];
        for (Vertex v : neighbours(c.a))
            offer(std::min(c.a, v), std::max(c.a, v));
    }

    std::vector<glm::dvec3> _places;
    std::vector<std::vector<std::size_t>> _around; ///< each vertex's triangles
    std::vector<Quadric> _quadrics;
    std::vector<unsigned> _versions;
    std::vector<Triangle> _triangles; ///< those that are gone are {0, 0, 0}
    std::size_t _alive = 0;
    std::priority_queue<Candidate> _queue;
};

} // namespace

Shell simplified(const Shell& shell, std::size_t triangles) {
    Simplifier simplifier{shell};
    simplifier.reduceTo(triangles);
    return simplifier.shell();
}

} // namespace limpid::models
