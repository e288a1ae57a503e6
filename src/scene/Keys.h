#pragma once
#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "scene/Scene.h"

/// Every key of a scene file, in one table (scene/KeyTable.cpp): a row each. Parser, writer, `--set`, manual,
/// completion, the viewer's panels, the fuzz dictionary and docs/scene-keys.md are made from it.
namespace limpid {

/// The numbers that a key takes. All are finite and at most 10¹² in size, so that squares and products of
/// three stay finite in single precision.
struct Range {
    double min = -1e12;
    double max = 1e12;
    bool openMin = false;   ///< `min` itself is not allowed
    bool openMax = false;   ///< `max` itself is not allowed
    bool direction = false; ///< a vector of any length but 0
    bool square = false;    ///< a vector, for which one number may stand
    int count = 1;          ///< numbers in a list, for a key without a member
    bool whole = false;     ///< likewise

    bool contains(double x) const { return (openMin ? x > min : x >= min) && (openMax ? x < max : x <= max); }
    /// " from 0 to 1e12", " > 0 and <= 1": completes "expected a number …".
    std::string text() const;
};

inline constexpr Range anyNumber{};
inline constexpr Range positive{.min = 0, .openMin = true};
inline constexpr Range nonNegative{.min = 0};
inline constexpr Range anyDirection{.direction = true};

/// The names of an enumeration, in its order.
struct Choice {
    std::span<const std::string_view> names;
    std::string_view remark{}; ///< closes the list in an error
};

/// A text, or a list of them.
struct Text {
    std::string_view expected; ///< what an error asks for
};

/// What of a key's row does not depend on where its value is kept.
struct KeyRow {
    std::string_view name; ///< within its section; dotted where a table of one line lies between
    std::variant<Range, Choice, Text> takes;
    std::string_view unit;
    std::string_view says; ///< one line of English
    /// In place of the member's own default: TOML, or words in parentheses.
    std::string_view initial{};
    /// Of a key without a member: a value, as TOML, that works in any scene that has the key.
    std::string_view example{};

    const Range& range() const { return std::get<Range>(takes); }
    const Choice& choice() const { return std::get<Choice>(takes); }
    const Text& text() const { return std::get<Text>(takes); }
};

/// The kinds of value that are read and written as they are. monostate: the loader does it by hand
/// (io/toml/SceneParser.cpp), with the name and the range of the row.
template <typename S>
using Member = std::variant<std::monostate, double S::*, int S::*, std::uint32_t S::*, glm::dvec2 S::*,
                            glm::dvec3 S::*, glm::ivec2 S::*, glm::dquat S::*, std::optional<glm::dvec2> S::*,
                            std::optional<glm::dvec3> S::*, WaveType S::*, Method S::*, Fill S::*,
                            Slicing S::*, PhotonGridOver S::*, GodrayMethod S::*, Phase S::*>;

/// A row: a key of the section that becomes an `S`.
template <typename S>
struct Key : KeyRow {
    Member<S> member{};
    bool (*when)(const S&) = nullptr; ///< whether it counts; null: always

    bool counts(const S& object) const { return !when || when(object); }
    template <typename T>
    bool is(T S::*other) const {
        return member == Member<S>(other);
    }
};

/// By section, in the order in which they are written.
extern const std::span<const Key<Camera>> cameraKeys;
extern const std::span<const Key<Water>> waterKeys;
extern const std::span<const Key<Wave>> waveKeys;
extern const std::span<const Key<Light>> lightKeys;
extern const std::span<const Key<Receiver>> receiverKeys;
extern const std::span<const Key<Scene>> skyKeys, ambientKeys;
extern const std::span<const Key<CausticsSettings>> causticsKeys;
extern const std::span<const Key<GodraySettings>> godrayKeys;

/// A wave or a light knows the keys of its type alone. Keys for other methods are taken, and rest.
template <typename S>
inline constexpr bool byType = std::is_same_v<S, Wave> || std::is_same_v<S, Light>;
template <typename S>
bool knows(const S& object, const Key<S>& key) {
    return !byType<S> || key.counts(object);
}

/// The row of a member; of two keys that share it, the one that `object` knows.
template <typename S, typename T>
const Key<S>& keyOf(std::span<const Key<S>> keys, T S::*member, const S& object = {}) {
    for (const Key<S>& key : keys)
        if (key.is(member) && knows(object, key)) return key;
    throw std::logic_error("a member without a key");
}

/// The range of a member: keys that share one share its range.
template <typename S, typename T>
const Range& rangeOf(std::span<const Key<S>> keys, T S::*member) {
    for (const Key<S>& key : keys)
        if (key.is(member)) return key.range();
    throw std::logic_error("a member without a key");
}

/// The row of a key that is read by hand.
template <typename S>
const Key<S>& keyNamed(std::span<const Key<S>> keys, std::string_view name) {
    for (const Key<S>& key : keys)
        if (key.name == name) return key;
    throw std::logic_error("no key of that name");
}

/// As TOML; empty without a member, and for a value that the key cannot take: it stands for none.
template <typename S>
std::string tomlOf(const Key<S>& key, const S& object);

/// A key for those who list them all.
struct KeyFacts : KeyRow {
    std::string_view section; ///< "camera", "water.wave"
    bool listed = false;      ///< the section is an array of tables
    std::string standard;     ///< by default: TOML, or words in parentheses
    std::string when;         ///< `type "spot"`, `method "photon-splat"`; empty: always
    std::string expected;     ///< "two numbers > 0", "\"drawn\" or \"one-pass\""
    /// The value that an entry of a scene (0 but for lists) has, as TOML; empty where the key does not count,
    /// and without a member.
    std::function<std::string(const Scene&, std::size_t entry)> present;
    /// Another one, valid by itself; without a member the row's example, of a shape's key for that shape.
    /// Empty where the key does not count, or needs others to change with it (files, a light's type).
    std::function<std::string(const Scene&, std::size_t entry)> another;

    /// As for `--set`, of entry 0 of a list: "water.wave.0.amplitude".
    std::string path(std::size_t entry = 0) const;
};

/// What it says, with unit, range, and when it counts, in one line: "crest to crest, m; a number > 0 …; for
/// type noise".
std::string sentenceOf(const KeyFacts& key);

/// All keys there are.
const std::vector<KeyFacts>& sceneKeys();

/// A wave or light of a type (an index of lightTypeNames) with the defaults of its keys; a phillips wave has
/// its wind, and no spectrum yet.
Wave defaultWave(WaveType type);
Light defaultLight(std::size_t type);

/// "a number > 0", "three whole numbers from 1 to 8"; `range` comes as Range::text has it.
std::string expectedNumbers(std::size_t count, bool whole, std::string_view range);
/// "a, b or c", each in quotes if so asked.
std::string eitherOf(std::span<const std::string_view> names, std::optional<char> quote = {});

/// Whether a section, by its dotted key, is an array of tables.
bool isListed(std::string_view section);

} // namespace limpid
