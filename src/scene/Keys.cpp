#include "scene/Keys.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "scene/MethodFacts.h"
#include "scene/Sea.h"

namespace limpid {

namespace {

/// 1e12 and 0.5, but 4294967295.
std::string limit(double value) {
    std::string text = fmt::format("{:g}", value);
    if (std::stod(text) != value) return fmt::format("{}", value);
    if (const std::size_t plus = text.find("e+"); plus != std::string::npos)
        text.erase(plus + 1, text[plus + 2] == '0' ? 2 : 1);
    return text;
}

// Values as TOML: the shortest text that is read as the same number. Empty for what the key cannot take.

template <typename T>
std::string toml(T value, const KeyRow& key) {
    if constexpr (std::is_enum_v<T>)
        return fmt::format("\"{}\"", key.choice().names[std::size_t(value)]);
    else
        return key.range().contains(double(value)) ? fmt::format("{}", value) : "";
}
template <int N, typename T>
std::string toml(const glm::vec<N, T>& value, const KeyRow& key) {
    std::string list;
    for (int i = 0; i < N; ++i) {
        if (!key.range().contains(double(value[i]))) return "";
        list += fmt::format("{}{}", i > 0 ? ", " : "", value[i]);
    }
    return fmt::format("[{}]", list);
}
std::string toml(const glm::dquat& q, const KeyRow& key) {
    return toml(glm::dvec4(q.x, q.y, q.z, q.w), key);
}
template <typename T>
std::string toml(const std::optional<T>& value, const KeyRow& key) {
    return value ? toml(*value, key) : "";
}

// Other values that are as valid, as far as the range says: powers of two stay such, and a vector's first
// component does not grow but where it may point anywhere.

template <typename T>
T other(T value, const KeyRow& key) {
    if constexpr (std::is_enum_v<T>) return T(std::size_t(value) == 0 ? 1 : 0);
    const double v = double(value);
    const auto candidates = std::is_integral_v<T> ? std::array{std::floor(v / 2), 2 * v, v + 1}
                                                  : std::array{0.75 * v, v + 0.25, v + 0.001};
    for (const double each : candidates)
        if (each != v && key.range().contains(each)) return T(each);
    return value;
}
template <int N, typename T>
glm::vec<N, T> other(glm::vec<N, T> value, const KeyRow& key) {
    if (key.range().direction)
        value.x += T(0.25), value.y += T(0.25); // turns it as well
    else
        value.x = other(value.x, key);
    return value;
}
glm::dquat other(const glm::dquat& q, const KeyRow&) {
    return q * glm::dquat(0.75, 0.25, 0.5, 0);
}
template <typename T>
std::optional<T> other(const std::optional<T>& value, const KeyRow& key) {
    return value ? other(*value, key) : T(1);
}

// One object of each kind that keys tell apart, by its name, with the defaults.

template <typename S>
struct Kind {
    std::string_view name;
    S object;
};
template <typename S>
std::vector<Kind<S>> kindsOf() {
    return {{"", {}}};
}
template <>
std::vector<Kind<Wave>> kindsOf() {
    std::vector<Kind<Wave>> kinds;
    for (std::size_t i = 0; i < std::size(waveTypeNames); ++i)
        kinds.push_back({waveTypeNames[i], defaultWave(WaveType(i))});
    return kinds;
}
template <>
std::vector<Kind<Light>> kindsOf() {
    std::vector<Kind<Light>> kinds;
    for (std::size_t i = 0; i < std::size(lightTypeNames); ++i)
        kinds.push_back({lightTypeNames[i], defaultLight(i)});
    return kinds;
}
template <>
std::vector<Kind<CausticsSettings>> kindsOf() {
    std::vector<Kind<CausticsSettings>> kinds;
    for (const MethodFacts& facts : methodFacts)
        kinds.push_back({facts.name, {.method = facts.method, .slicing = Slicing::Levels}});
    return kinds;
}
template <>
std::vector<Kind<GodraySettings>> kindsOf() {
    std::vector<Kind<GodraySettings>> kinds;
    for (const GodrayMethod method : allGodrayMethods())
        kinds.push_back({godrayMethodName(method), {.method = method}});
    return kinds;
}

template <typename S>
std::string whenOf(const Key<S>& key) {
    std::vector<std::string_view> names;
    const std::vector<Kind<S>> kinds = kindsOf<S>();
    for (const Kind<S>& kind : kinds)
        if (key.counts(kind.object)) names.push_back(kind.name);
    if (names.size() == kinds.size()) return "";
    return fmt::format(
        "{} {}", requires(S s) { s.method; } ? "method" : "type", eitherOf(names));
}

template <typename S>
std::string standardOf(const Key<S>& key) {
    if (!key.initial.empty()) return std::string(key.initial);
    if (key.member == Member<S>()) return "(none)";
    if (!byType<S>) return tomlOf(key, S{});
    const std::vector<Kind<S>> kinds = kindsOf<S>();
    const auto first = std::find_if(kinds.begin(), kinds.end(),
                                    [&](const Kind<S>& kind) { return key.counts(kind.object); });
    return tomlOf(key, first->object);
}

template <typename T>
constexpr std::size_t countOf = 1;
template <int N, typename T>
constexpr std::size_t countOf<glm::vec<N, T>> = N;
template <>
constexpr std::size_t countOf<glm::dquat> = 4;
template <typename T>
constexpr std::size_t countOf<std::optional<T>> = countOf<T>;

/// Of numbers: how many, and whether they are whole.
template <typename S>
std::pair<std::size_t, bool> numbersOf(const Key<S>& key) {
    return std::visit(
        [&]<typename M>(M member) -> std::pair<std::size_t, bool> {
            if constexpr (std::is_same_v<M, std::monostate>) {
                return {std::size_t(key.range().count), key.range().whole};
            } else {
                using T = std::remove_cvref_t<decltype(std::declval<S&>().*member)>;
                return {countOf<T>, std::is_integral_v<T> || std::is_same_v<T, glm::ivec2>};
            }
        },
        key.member);
}

/// Without the bounds that all numbers have.
std::string boundsOf(const Range& range) {
    if (range.max < anyNumber.max) return range.text();
    if (range.min > anyNumber.min) return fmt::format(" {} {}", range.openMin ? ">" : ">=", limit(range.min));
    return range.direction ? ", not all 0" : "";
}

template <typename S>
std::string expectedOf(const Key<S>& key) {
    if (const Choice* choice = std::get_if<Choice>(&key.takes)) return eitherOf(choice->names, '"');
    if (const Text* text = std::get_if<Text>(&key.takes)) return std::string(text->expected);
    const auto [count, whole] = numbersOf(key);
    return expectedNumbers(count, whole, boundsOf(key.range()));
}

template <typename S>
std::string anotherOf(const Key<S>& key, S object) {
    std::visit(
        [&]<typename M>(M member) {
            if constexpr (!std::is_same_v<M, std::monostate>) object.*member = other(object.*member, key);
        },
        key.member);
    return tomlOf(key, object);
}

/// The section's object in a scene; null for an entry that it has not.
template <typename S>
using Find = const S* (*)(const Scene&, std::size_t entry);

template <typename T>
const T* entryOf(const std::vector<T>& list, std::size_t entry) {
    return entry < list.size() ? &list[entry] : nullptr;
}

template <typename S>
KeyFacts factsOfKey(std::string_view section, bool listed, const Key<S>& key, Find<S> find) {
    KeyFacts facts{key, section, listed, standardOf(key), whenOf(key), expectedOf(key), {}, {}};
    facts.present = [&key, find](const Scene& scene, std::size_t entry) {
        const S* object = find(scene, entry);
        return object && key.counts(*object) ? tomlOf(key, *object) : "";
    };
    facts.another = [&key, find](const Scene& scene, std::size_t entry) {
        const S* object = find(scene, entry);
        if (!object || !key.counts(*object)) return std::string();
        return key.member == Member<S>() ? std::string(key.example) : anotherOf(key, *object);
    };
    return facts;
}

template <typename S>
void addSection(std::vector<KeyFacts>& all, std::string_view section, bool listed,
                std::span<const Key<S>> keys, Find<S> find) {
    for (const Key<S>& key : keys)
        all.push_back(factsOfKey(section, listed, key, find));
}

std::vector<KeyFacts> allKeys() {
    using Entry = std::size_t;
    std::vector<KeyFacts> all;
    addSection<Camera>(all, "camera", false, cameraKeys, [](const Scene& s, Entry) { return &s.camera; });
    addSection<Water>(all, "water", false, waterKeys, [](const Scene& s, Entry) { return &s.water; });
    addSection<Wave>(all, "water.wave", true, waveKeys,
                     [](const Scene& s, Entry i) { return entryOf(s.water.waves, i); });
    addSection<Light>(all, "light", true, lightKeys,
                      [](const Scene& s, Entry i) { return entryOf(s.lights, i); });
    addSection<Receiver>(all, "receiver", true, receiverKeys,
                         [](const Scene& s, Entry i) { return entryOf(s.receivers, i); });
    addSection<Scene>(all, "sky", false, skyKeys, [](const Scene& s, Entry) { return &s; });
    addSection<Scene>(all, "ambient", false, ambientKeys, [](const Scene& s, Entry) { return &s; });
    addSection<CausticsSettings>(all, "caustics", false, causticsKeys,
                                 [](const Scene& s, Entry) { return &s.caustics; });
    addSection<GodraySettings>(all, "godrays", false, godrayKeys,
                               [](const Scene& s, Entry) { return &s.godrays; });
    return all;
}

} // namespace

std::string Range::text() const {
    if (!openMin && !openMax) return fmt::format(" from {} to {}", limit(min), limit(max));
    return fmt::format(" {} {} and {} {}", openMin ? ">" : ">=", limit(min),
                       openMax ? "<" : "<=", limit(max));
}

std::string expectedNumbers(std::size_t count, bool whole, std::string_view range) {
    constexpr std::string_view words[] = {"no", "a", "two", "three", "four"};
    return fmt::format("{} {}number{}{}", words[std::min(count, std::size(words) - 1)], whole ? "whole " : "",
                       count == 1 ? "" : "s", range);
}

std::string eitherOf(std::span<const std::string_view> names, std::optional<char> quote) {
    const std::string mark = quote ? std::string(1, *quote) : "";
    std::string list;
    for (std::size_t i = 0; i < names.size(); ++i)
        list += fmt::format("{}{}{}{}",
                            i == 0                  ? ""
                            : i + 1 == names.size() ? " or "
                                                    : ", ",
                            mark, names[i], mark);
    return list;
}

Wave defaultWave(WaveType type) {
    Wave wave;
    if (type == WaveType::Phillips) setWind(wave, {});
    wave.type = type;
    return wave;
}

Light defaultLight(std::size_t type) {
    Light light;
    if (type > 0) light.type = LightType::Point;
    if (type == 2) light.outerCone = 45;
    return light;
}

template <typename S>
std::string tomlOf(const Key<S>& key, const S& object) {
    return std::visit(
        [&]<typename M>(M member) -> std::string {
            if constexpr (std::is_same_v<M, std::monostate>)
                return "";
            else
                return toml(object.*member, key);
        },
        key.member);
}
template std::string tomlOf(const Key<Camera>&, const Camera&);
template std::string tomlOf(const Key<Water>&, const Water&);
template std::string tomlOf(const Key<Wave>&, const Wave&);
template std::string tomlOf(const Key<Light>&, const Light&);
template std::string tomlOf(const Key<Receiver>&, const Receiver&);
template std::string tomlOf(const Key<Scene>&, const Scene&);
template std::string tomlOf(const Key<CausticsSettings>&, const CausticsSettings&);
template std::string tomlOf(const Key<GodraySettings>&, const GodraySettings&);

std::string KeyFacts::path(std::size_t entry) const {
    return listed ? fmt::format("{}.{}.{}", section, entry, name) : fmt::format("{}.{}", section, name);
}

std::string sentenceOf(const KeyFacts& key) {
    return fmt::format("{}{}{}; {}{}{}", key.says, key.unit.empty() ? "" : ", ", key.unit, key.expected,
                       key.when.empty() ? "" : "; for ", key.when);
}

const std::vector<KeyFacts>& sceneKeys() {
    static const std::vector<KeyFacts> keys = allKeys();
    return keys;
}

bool isListed(std::string_view section) {
    const auto& keys = sceneKeys();
    return std::any_of(keys.begin(), keys.end(),
                       [&](const KeyFacts& key) { return key.listed && key.section == section; });
}

} // namespace limpid
