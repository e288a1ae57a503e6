#include "io/NamePatterns.h"

#include <algorithm>

#include <fnmatch.h>

#include "io/toml/TomlReader.h"

namespace limpid::io {

bool NamePatterns::match(const std::string& name) const {
    return !name.empty() && std::any_of(_patterns.begin(), _patterns.end(), [&](const std::string& pattern) {
        return ::fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
    });
}

NamePatterns parseWithout(TomlTable& receiver) {
    const KeyRow& key = keyNamed(receiverKeys, "without");
    const std::string expected(key.text().expected);
    std::vector<std::string> patterns;
    receiver.texts(key.name, patterns, expected);
    for (const std::string& pattern : patterns)
        if (pattern.empty()) receiver.fail(key.name, expected);
    return NamePatterns(std::move(patterns));
}

} // namespace limpid::io
