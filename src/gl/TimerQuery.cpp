#include "gl/TimerQuery.h"

#include <algorithm>

namespace limpid::gl {

namespace {
constexpr std::size_t mostPending = 4096; // scopes; those of some hundred frames
}

PassTimers::~PassTimers() {
    for (const Stamps& stamps : _pending)
        _free.insert(_free.end(), {stamps.begin, stamps.end});
    if (!_free.empty()) glDeleteQueries(GLsizei(_free.size()), _free.data());
}

GLuint PassTimers::take() {
    GLuint query = 0;
    if (_free.empty()) {
        glCreateQueries(GL_TIMESTAMP, 1, &query);
    } else {
        query = _free.back();
        _free.pop_back();
    }
    return query;
}

/// Reads the oldest of what is pending, up to what still runs.
void PassTimers::read(std::size_t count) {
    std::size_t done = 0;
    for (; done < count && !_pending[done].open; ++done) {
        const Stamps& stamps = _pending[done];
        GLuint64 begin = 0, end = 0;
        glGetQueryObjectui64v(stamps.begin, GL_QUERY_RESULT, &begin);
        glGetQueryObjectui64v(stamps.end, GL_QUERY_RESULT, &end);
        auto entry =
            std::find_if(_times.begin(), _times.end(), [&](const auto& t) { return t.first == stamps.pass; });
        if (entry == _times.end()) entry = _times.emplace(_times.end(), stamps.pass, 0.0);
        entry->second += end > begin ? double(end - begin) * 1e-6 : 0.0;
        _free.insert(_free.end(), {stamps.begin, stamps.end});
    }
    _pending.erase(_pending.begin(), _pending.begin() + std::ptrdiff_t(done));
}

PassTimers::Scope::Scope(PassTimers& timers, const char* pass) : _timers(timers) {
    if (timers._pending.size() >= mostPending) timers.read(mostPending / 2);
    const GLuint begin = timers.take();
    _end = timers.take();
    timers._pending.push_back({pass, begin, _end});
    glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, pass);
    glQueryCounter(begin, GL_TIMESTAMP);
}

PassTimers::Scope::~Scope() {
    glQueryCounter(_end, GL_TIMESTAMP);
    glPopDebugGroup();
    const auto ends = [&](const Stamps& stamps) { return stamps.end == _end; };
    std::find_if(_timers._pending.rbegin(), _timers._pending.rend(), ends)->open = false;
}

std::vector<std::pair<std::string, double>> PassTimers::collect() {
    read(_pending.size());
    return std::exchange(_times, {});
}

} // namespace limpid::gl
