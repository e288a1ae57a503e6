#include "apps/viewer/Gizmo.h"

#include <algorithm>
#include <cmath>

#include "core/Tau.h"

namespace limpid::viewer {

namespace {

constexpr int pieces = 32; ///< straight ones that a handle's line is looked at in

double distanceToLine(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
    const glm::dvec2 way = b - a;
    const double square = glm::dot(way, way);
    const double t = square > 0 ? std::clamp(glm::dot(p - a, way) / square, 0.0, 1.0) : 0;
    return glm::distance(p, a + t * way);
}

} // namespace

glm::dvec3 meshMiddle(const Mesh& mesh) {
    Bounds bounds;
    for (const auto& position : mesh.positions)
        bounds.add(glm::dvec3(position));
    return bounds.empty() ? glm::dvec3(0) : bounds.center();
}

Gizmo::Gizmo(const Receiver& receiver, const glm::dvec3& meshMiddle, Mode wanted,
             const Projection& projection, double pixels)
    : mode(wanted), middle(receiver.toWorld(meshMiddle)),
      axes(wanted == Mode::Scale ? glm::mat3_cast(receiver.rotation) : glm::dmat3(1)),
      size(pixels * projection.pixelSize(middle)) {
    if (mode == Mode::Turn) return;
    const auto from = projection.pixel(middle);
    for (int axis = 0; axis < axisCount; ++axis) {
        const auto to = projection.pixel(at(axis, size));
        hidden[axis] = !from || !to || glm::distance(*from, *to) < 0.2 * pixels;
    }
}

glm::dvec3 Gizmo::at(int axis, double s) const {
    if (mode != Mode::Turn) return middle + s * axes[axis];
    return middle + size * (std::cos(s) * axes[(axis + 1) % 3] + std::sin(s) * axes[(axis + 2) % 3]);
}

glm::dvec2 Gizmo::ends() const {
    // Arrows leave the middle free for whoever wants to pick what is there.
    return mode == Mode::Turn ? glm::dvec2(0, tau) : glm::dvec2(0.2, 1) * size;
}

std::optional<int> Gizmo::under(const glm::dvec2& mouse, double reach, const Projection& projection) const {
    std::optional<int> nearest;
    for (int axis = 0; axis < axisCount; ++axis) {
        if (hidden[axis]) continue;
        std::optional<glm::dvec2> last;
        for (int i = 0; i <= pieces; ++i) {
            const auto pixel = projection.pixel(at(axis, glm::mix(ends().x, ends().y, double(i) / pieces)));
            if (last && pixel)
                if (const double distance = distanceToLine(mouse, *last, *pixel); distance < reach)
                    reach = distance, nearest = axis;
            last = pixel;
        }
    }
    return nearest;
}

/// Newton's steps on straight pieces of the line; one that leads away from the mouse is halved.
double Gizmo::follow(int axis, double s, const glm::dvec2& mouse, const Projection& projection) const {
    const double unit = mode == Mode::Turn ? 1 : size, h = 1e-4 * unit,
                 longest = mode == Mode::Turn ? 0.5 : size;
    const auto off = [&](double place) -> std::optional<glm::dvec2> {
        const auto pixel = projection.pixel(at(axis, place));
        if (!pixel) return std::nullopt;
        return mouse - *pixel;
    };
    for (int i = 0; i < 100; ++i) {
        const auto here = off(s), before = off(s - h), after = off(s + h);
        if (!here || !before || !after) break;
        const glm::dvec2 slope = (*before - *after) / (2 * h); // pixels a unit
        const double square = glm::dot(slope, slope);
        if (!(square > 0)) break;
        double step = std::clamp(glm::dot(*here, slope) / square, -longest, longest);
        const auto closer = [&] {
            const auto there = off(s + step);
            return there && glm::length(*there) < glm::length(*here);
        };
        while (std::abs(step) > 1e-9 * unit && !closer())
            step *= 0.5;
        if (std::abs(step) <= 1e-9 * unit) break;
        s += step;
    }
    return s;
}

GizmoDrag::GizmoDrag(const Receiver& receiver, const Gizmo& gizmo, int axis, const glm::dvec2& mouse,
                     const Projection& projection)
    : _start(receiver), _now(receiver), _gizmo(gizmo), _axis(axis) {
    // A ring is grabbed at its nearest place, of which there may be two.
    _grabbed = 0.5 * (gizmo.ends().x + gizmo.ends().y);
    double least = 1e300;
    for (int i = 0; i <= pieces; ++i) {
        const double s = glm::mix(gizmo.ends().x, gizmo.ends().y, double(i) / pieces);
        const auto pixel = projection.pixel(gizmo.at(axis, s));
        if (pixel && glm::distance(*pixel, mouse) < least) least = glm::distance(*pixel, mouse), _grabbed = s;
    }
    _grabbed = gizmo.follow(axis, _grabbed, mouse, projection);
    _at = _grabbed;
}

const Receiver& GizmoDrag::to(const glm::dvec2& mouse, const Projection& projection, bool alike) {
    _at = _gizmo.follow(_axis, _at, mouse, projection);
    _now = _start;
    if (_gizmo.mode == Gizmo::Mode::Move) move(_at - _grabbed);
    if (_gizmo.mode == Gizmo::Mode::Turn) turn(_at - _grabbed);
    if (_gizmo.mode == Gizmo::Mode::Scale) scale(std::max(_at / _grabbed, 0.01), alike);
    return _now;
}

void GizmoDrag::move(double way) {
    _now.translation += way * _gizmo.axes[_axis];
}

void GizmoDrag::turn(double angle) {
    const glm::dquat turn = glm::angleAxis(angle, _gizmo.axes[_axis]);
    _now.rotation = glm::normalize(turn * _start.rotation);
    _now.translation = _gizmo.middle + turn * (_start.translation - _gizmo.middle);
}

void GizmoDrag::scale(double factor, bool alike) {
    const glm::dvec3 own =
        glm::conjugate(_start.rotation) * (_gizmo.middle - _start.translation) / _start.scale;
    if (alike)
        _now.scale *= factor;
    else
        _now.scale[_axis] *= factor;
    _now.translation = _gizmo.middle - _now.rotation * (_now.scale * own);
}

} // namespace limpid::viewer
