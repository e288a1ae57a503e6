#pragma once
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

/// Variants of a shader: one for each set of names that its conditions ask for.
namespace limpid::gl {

using Names = std::vector<std::string>;

/// Every first group of `expression` in `text`, once.
inline std::set<std::string> found(const std::string& text, const char* expression) {
    const std::regex regex(expression);
    return {std::sregex_token_iterator(text.begin(), text.end(), regex, 1), std::sregex_token_iterator()};
}

/// Names in conditions, but for those that the text itself defines.
inline Names choices(const std::string& text) {
    std::set<std::string> names;
    for (const std::string& condition : found(text, R"(\n#if([^\n]*))"))
        names.merge(found(condition, R"(\b([A-Z_]{3,})\b)"));
    for (const std::string& own : found(text, R"(\n#define (\w+))"))
        names.erase(own);
    return {names.begin(), names.end()};
}

/// Every subset of `names`.
inline std::vector<Names> subsets(const Names& names) {
    std::vector<Names> all(std::size_t(1) << names.size());
    for (std::size_t choice = 0; choice < all.size(); ++choice)
        for (std::size_t i = 0; i < names.size(); ++i)
            if (choice >> i & 1) all[choice].push_back(names[i]);
    return all;
}

} // namespace limpid::gl
