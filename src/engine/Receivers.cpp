#include "engine/Receivers.h"

#include <algorithm>
#include <optional>

namespace limpid {

namespace {

bool sameButName(Receiver a, const Receiver& b) {
    a.name = b.name;
    return a == b;
}

} // namespace

void Receivers::set(std::span<const Receiver> receivers, const glm::dvec3& origin) {
    std::vector<std::optional<ReceiverGeometry>> made(receivers.size());
    for (std::size_t i = 0; i < made.size(); ++i) {
        const bool same =
            i < _receivers.size() && origin == _origin && sameButName(receivers[i], _receivers[i]);
        if (!same) made[i].emplace(_context, receivers[i], origin);
    }
    std::vector<ReceiverGeometry> geometries;
    std::vector<Stamp> stamps;
    for (std::size_t i = 0; i < made.size(); ++i) {
        stamps.push_back(made[i] ? _making.next() : _stamps[i]);
        geometries.push_back(std::move(made[i] ? *made[i] : _geometries[i]));
    }
    _geometries = std::move(geometries);
    _stamps = std::move(stamps);
    _translucent = std::any_of(_geometries.begin(), _geometries.end(),
                               [](const ReceiverGeometry& geometry) { return geometry.translucent(); });
    _receivers.assign(receivers.begin(), receivers.end());
    _origin = origin;
}

std::vector<Stamp> Receivers::stampsOf(std::span<const int> numbers) const {
    std::vector<Stamp> stamps;
    for (const int number : numbers)
        stamps.push_back(stamp(number));
    return stamps;
}

const Occluders& Receivers::occluders(gl::PassTimers& timers) {
    _occludersOf.bring(_making, _stamps, [&] {
        gl::PassTimers::Scope scope(timers, "occluders");
        _occluders.reset();
        _occluders = std::make_unique<Occluders>(_context, _receivers, _origin);
    });
    return *_occluders;
}

} // namespace limpid
