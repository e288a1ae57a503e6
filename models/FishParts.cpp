#include "FishParts.h"

#include "Shapes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace limpid::models {

Shell fan(const Fan& f) {
    const auto flat = [&](double u, double v) {
        const double between = f.spines ? std::abs(std::sin(glm::pi<double>() * v * f.spines)) : 0.0;
        return glm::mix(along(f.root, v), along(f.tip, v), u * (1.0 - f.jag * between * u));
    };
    const auto middle = [&](double u, double v) {
        if (f.ripple == 0.0) return flat(u, v);
        const double e = 1e-3;
        const glm::dvec3 normal = glm::normalize(
            glm::cross(flat(0.5 + e, v) - flat(0.5 - e, v), flat(0.5, v + e) - flat(0.5, v - e)));
        return flat(u, v) + f.ripple * u * std::sin(glm::two_pi<double>() * f.waves * v) * normal;
    };
    return sheet({.middle = middle,
                  .half = [&](double u, double) { return f.halfThickness * (1.0 - 0.7 * u); },
                  .colour = f.colour,
                  .nu = f.nu,
                  .nv = f.nv});
}

std::function<glm::dvec3(double, double)> finColours(unsigned base, unsigned edge, int rays) {
    return [=](double u, double v) {
        const double ray = rays ? 0.25 * (0.5 - 0.5 * std::cos(glm::two_pi<double>() * rays * v)) : 0.0;
        return glm::mix(rgb(base), rgb(edge), u * u) * (1.0 - ray);
    };
}

namespace {

// The rows' spline at the place where it passes x.
BodyRow rowAt(const std::vector<glm::dvec3>& heights, const std::vector<glm::dvec3>& widths, double x) {
    double low = 0.0, high = 1.0; // x falls with t
    for (int i = 0; i < 50; ++i) {
        const double middle = 0.5 * (low + high);
        (along(heights, middle).x > x ? low : high) = middle;
    }
    const glm::dvec3 height = along(heights, low);
    return {x, height.y, height.z, std::max(along(widths, low).y, 1e-4)};
}

} // namespace

Shell evenBody(const std::vector<BodyRow>& rows, int rings, int sides) {
    std::vector<glm::dvec3> heights, widths;
    for (const BodyRow& row : rows) {
        heights.emplace_back(row.x, row.top, row.bottom);
        widths.emplace_back(row.x, row.halfWidth, 0.0);
    }
    std::vector<BodyRow> even{rows.front()};
    for (int ring = 1; ring <= rings; ++ring) {
        const double s = double(ring) / (rings + 1);
        const double spread = s - 0.6 * std::sin(glm::two_pi<double>() * s) / glm::two_pi<double>();
        even.push_back(rowAt(heights, widths, glm::mix(rows.front().x, rows.back().x, spread)));
    }
    even.push_back(rows.back());
    return body(even, {.ringsPerSpan = 1, .sides = sides});
}

Shell withFace(Shell body, const Face& face) {
    // How far behind the gill cover's edge, negative on it.
    const auto behind = [=](const glm::dvec3& p) {
        return face.gill.x - p.x > 0.0 ? glm::distance(glm::dvec2{p}, face.gill) - face.gillRadius : -0.1;
    };
    const auto lip = [=](const glm::dvec3& p) {
        const double t = (face.noseX - p.x) / (face.noseX - face.mouth.x);
        return t > 1.0 ? 0.1 : std::abs(p.y - glm::mix(face.noseY, face.mouth.y, t));
    };
    const std::vector<glm::dvec3> before = body.positions;
    for (std::size_t i = 0; i < before.size(); ++i)
        body.colours[i] *=
            1.0 - 0.55 * bump(0.004, 0.014, behind(before[i])) - 0.6 * bump(0.0, 0.010, lip(before[i]));
    return swollen(std::move(body), [=](const glm::dvec3& p) {
        const double cover = (1.0 - ramp(-0.006, 0.006, behind(p))) * ramp(-0.09, -0.01, behind(p));
        return 0.007 * cover - 0.007 * bump(0.0, 0.012, lip(p));
    });
}

Shell eye(const glm::dvec3& centre, double radius, unsigned iris) {
    return painted(globe(centre, radius, 10, 14), [&](const glm::dvec3& p) {
        const double out = (p.z - centre.z) / radius;
        return out > 0.85 ? rgb(0x080808) : out > 0.5 ? rgb(iris) : rgb(0x202020);
    });
}

void Assembly::add(Shell part, double crease) {
    if (_shape) part = shaped(std::move(part), _shape);
    appendCreased(_mesh, part, crease);
}

void Assembly::addPair(const Shell& part, double crease) {
    add(part, crease);
    add(mirroredInZ(part), crease);
}

std::function<glm::dvec3(const glm::dvec3&)> swimming(double from, double reach) {
    return [=](glm::dvec3 p) {
        const double rear = std::max(from - p.x, 0.0) / (from + 0.5);
        p.z += reach * rear * rear * (1.6 - 0.6 * rear);
        return p;
    };
}

} // namespace limpid::models
