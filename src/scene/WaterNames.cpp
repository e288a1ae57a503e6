#include "scene/WaterNames.h"

#include <algorithm>
#include <cctype>
#include <span>
#include <string>
#include <vector>

namespace limpid {

namespace {

constexpr std::string_view waters[] = {"water", "ocean", "sea",    "lake",  "river", "seawater",
                                       "pond",  "eau",   "wasser", "acqua", "agua",  "voda"};

/// Vessels in front of it make no other thing of water; behind it they do ("water tank").
constexpr std::string_view vessels[] = {
    "pool", "swimming", "basin",    "bath",     "tub",     "bathtub", "hot", "jacuzzi", "spa",  "tank",
    "pond", "lake",     "fountain", "aquarium", "harbour", "harbor",  "sea", "ocean",   "river"};

constexpr std::string_view neutral[] = {
    "surface", "surf",       "plane", "sheet",  "mesh",     "body",   "volume", "level",   "top",
    "grid",    "patch",      "tile",  "layer",  "object",   "obj",    "geo",    "geom",    "geometry",
    "shape",   "model",      "node",  "prim",   "lod",      "low",    "high",   "lp",      "hp",
    "sm",      "mi",         "mat",   "mtl",    "material", "shader", "the",    "of",      "a",
    "my",      "main",       "new",   "clear",  "clean",    "fresh",  "deep",   "shallow", "calm",
    "still",   "blue",       "green", "big",    "small",    "wave",   "waves",  "wavy",    "ripples",
    "sim",     "simulation", "fluid", "liquid", "animated", "anim",   "static", "copy",    "final",
    "m",       "s",          "d",     "x"};

bool isIn(std::span<const std::string_view> list, std::string_view word) {
    return std::find(list.begin(), list.end(), word) != list.end();
}

/// Words in lower case: letters, parted by all else and where a capital follows a small letter.
std::vector<std::string> wordsOf(std::string_view name) {
    std::vector<std::string> words;
    bool within = false;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const auto c = static_cast<unsigned char>(name[i]);
        const bool letter = std::isalpha(c) || c >= 0x80;
        const bool begins = std::isupper(c) && i > 0 && std::islower(static_cast<unsigned char>(name[i - 1]));
        if (letter && (!within || begins)) words.emplace_back();
        if (letter) words.back() += static_cast<char>(c < 0x80 ? std::tolower(c) : c);
        within = letter;
    }
    return words;
}

/// Words run together, as in "poolwater" or "waterplane": parted where each part is known. False if none are.
bool partInto(std::string_view word, std::vector<std::string>& parts) {
    if (word.empty()) return true;
    for (std::size_t length = word.size(); length > 0; --length) {
        const std::string_view head = word.substr(0, length);
        if (!isIn(waters, head) && !isIn(vessels, head) &&
            !(isIn(neutral, head) && (length > 2 || length == word.size())))
            continue;
        parts.emplace_back(head);
        if (partInto(word.substr(length), parts)) return true;
        parts.pop_back();
    }
    return false;
}

} // namespace

bool namesWater(std::string_view name) {
    std::vector<std::string> words;
    for (const std::string& word : wordsOf(name))
        if (!partInto(word, words)) return false;
    const auto water = std::find_if(words.rbegin(), words.rend(),
                                    [](const std::string& word) { return isIn(waters, word); });
    if (water == words.rend()) return false;
    return std::all_of(words.rbegin(), water, [](const std::string& word) { return isIn(neutral, word); });
}

} // namespace limpid
