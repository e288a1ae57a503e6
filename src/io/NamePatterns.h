#pragma once
#include <string>
#include <vector>

namespace limpid::io {

/// Shell-style patterns of names: `*`, `?`, `[a-z]`, and a backslash before what is meant as it stands. Case
/// counts.
class NamePatterns {
  public:
    NamePatterns() = default;
    explicit NamePatterns(std::vector<std::string> patterns) : _patterns(std::move(patterns)) {}

    const std::vector<std::string>& patterns() const { return _patterns; }
    bool empty() const { return _patterns.empty(); }

    /// True for a name, not empty, that one of the patterns stands for.
    bool match(const std::string& name) const;

    bool operator<(const NamePatterns& other) const { return _patterns < other._patterns; }

  private:
    std::vector<std::string> _patterns;
};

} // namespace limpid::io
