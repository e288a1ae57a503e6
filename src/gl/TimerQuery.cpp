#include "gl/TimerQuery.h"

#include <algorithm>

namespace limpid::gl {

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

PassTimers::Scope::Scope(PassTimers& timers, const char* pass) {
    const GLuint begin = timers.take();
    _end = timers.take();
    timers._pending.push_back({pass, begin, _end});
    glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, pass);
    glQueryCounter(begin, GL_TIMESTAMP);
}

PassTimers::Scope::~Scope() {
    glQueryCounter(_end, GL_TIMESTAMP);
    glPopDebugGroup();
}

std::vector<std::pair<std::string, double>> PassTimers::collect() {
    std::vector<std::pair<std::string, double>> times;
    for (const Stamps& stamps : _pending) {
        GLuint64 begin = 0, end = 0;
        glGetQueryObjectui64v(stamps.begin, GL_QUERY_RESULT, &begin);
        glGetQueryObjectui64v(stamps.end, GL_QUERY_RESULT, &end);
        auto entry =
            std::find_if(times.begin(), times.end(), [&](const auto& t) { return t.first == stamps.pass; });
        if (entry == times.end()) entry = times.emplace(times.end(), stamps.pass, 0.0);
        entry->second += end > begin ? double(end - begin) * 1e-6 : 0.0;
        _free.insert(_free.end(), {stamps.begin, stamps.end});
    }
    _pending.clear();
    return times;
}

} // namespace limpid::gl
