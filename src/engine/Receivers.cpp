#include "engine/Receivers.h"

#include <algorithm>
#include <optional>

namespace limpid {

namespace {

bool sameButName(Receiver a, const Receiver& b) {
    a.name = b.name;
    return a == b;
}

/// What becomes of a receiver on the GPU when there is another in its place.
enum class Change { None, Moved, Another };

/// Triangles of a host's are its own to move.
Change changeOf(const Receiver& before, const Receiver& now, bool sameOrigin) {
    if (sameOrigin && sameButName(now, before)) return Change::None;
    return now.mesh == before.mesh && !now.host && !before.host ? Change::Moved : Change::Another;
}

} // namespace

void Receivers::set(std::span<const Receiver> receivers, const glm::dvec3& origin) {
    std::vector<Change> changes;
    std::vector<std::optional<ReceiverGeometry>> made(receivers.size());
    for (std::size_t i = 0; i < made.size(); ++i) {
        changes.push_back(i < _receivers.size() ? changeOf(_receivers[i], receivers[i], origin == _origin)
                                                : Change::Another);
        if (changes[i] == Change::Another) made[i].emplace(_context, receivers[i], origin);
    }
    // From here on nothing fails.
    std::vector<ReceiverGeometry> geometries;
    std::vector<Stamp> stamps;
    for (std::size_t i = 0; i < made.size(); ++i) {
        if (changes[i] == Change::Moved) _geometries[i].place(receivers[i], origin);
        stamps.push_back(changes[i] == Change::None ? _stamps[i] : _making.next());
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
