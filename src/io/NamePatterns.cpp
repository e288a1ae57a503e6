#include "io/NamePatterns.h"

#include <algorithm>

#include <fnmatch.h>

namespace limpid::io {

bool NamePatterns::match(const std::string& name) const {
    return !name.empty() && std::any_of(_patterns.begin(), _patterns.end(), [&](const std::string& pattern) {
        return ::fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
    });
}

} // namespace limpid::io
