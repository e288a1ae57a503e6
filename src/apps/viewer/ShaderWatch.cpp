#include "apps/viewer/ShaderWatch.h"

#include <algorithm>
#include <utility>

#include "gl/ShaderLibrary.h"

namespace fs = std::filesystem;

namespace limpid::viewer {

ShaderWatch::ShaderWatch() : _folder(gl::shaderFolder()), _known(newest()) {}

fs::file_time_type ShaderWatch::newest() const {
    auto newest = fs::file_time_type::min();
    std::error_code error;
    for (fs::recursive_directory_iterator file(_folder, error), end; !error && file != end;
         file.increment(error)) {
        std::error_code gone; // an editor may replace the file just now
        const auto time = file->last_write_time(gone);
        if (!gone) newest = std::max(newest, time);
    }
    return newest;
}

bool ShaderWatch::changed() {
    const auto now = std::chrono::steady_clock::now();
    if (_folder.empty() || now - _looked < std::chrono::milliseconds(500)) return false;
    _looked = now;
    const auto time = newest();
    return time > std::exchange(_known, std::max(_known, time));
}

} // namespace limpid::viewer
