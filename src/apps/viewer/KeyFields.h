#pragma once
#include "apps/viewer/Widgets.h"
#include "scene/Keys.h"

/// Fields of the panels as the table of keys has them: a row's name, range, unit and words.
namespace limpid::viewer::widgets {

/// The row's name as a label.
std::string labelOf(const KeyRow& key);
/// The row's words as a tooltip for the field before.
void keyHint(const KeyRow& key);
/// Its range; a pixel of a drag changes numbers about `value` by a good part of them, and what may lie
/// anywhere by `length`, m.
Field fieldOf(const KeyRow& key, double value, double length = 0.01);

// Each returns whether the user changed it.
bool keyField(const KeyRow& key, std::span<double> values, const Field& field);
bool keyField(const KeyRow& key, double& value, double length);
bool keyField(const KeyRow& key, int& value, double length);
bool keyField(const KeyRow& key, std::uint32_t& value, double length);
bool keyField(const KeyRow& key, glm::ivec2& value, double length);
/// A choice, by its place in the names.
bool keyChoice(const KeyRow& key, std::size_t& value);

template <int N>
bool keyField(const KeyRow& key, glm::vec<N, double>& value, double length) {
    const double size = glm::length(value);
    glm::vec<N, double> changed = value;
    if (!keyField(key, std::span<double>(&changed[0], N), fieldOf(key, size, length))) return false;
    if (key.range().direction && glm::dot(changed, changed) < 1e-6) return false;
    value = changed;
    return true;
}

template <typename T>
bool keyField(const KeyRow& key, std::optional<T>& value, double length) {
    return value && keyField(key, *value, length);
}

template <typename T>
requires std::is_enum_v<T>
bool keyField(const KeyRow& key, T& value, double) {
    auto index = std::size_t(value);
    if (!keyChoice(key, index)) return false;
    value = T(index);
    return true;
}

/// A field for each member of a section that counts, but where `own`, asked with each row, says that it needs
/// none: it has drawn it itself, or it is not for the panel.
template <typename S, typename Own>
void keyFields(std::span<const Key<S>> keys, S& object, double length, Own&& own) {
    for (const Key<S>& key : keys) {
        if (!key.counts(object) || own(key)) continue;
        std::visit(
            [&]<typename M>(M member) {
                constexpr bool none = std::is_same_v<M, std::monostate> || std::is_same_v<M, glm::dquat S::*>;
                if constexpr (!none) keyField(key, object.*member, length);
            },
            key.member);
    }
}

} // namespace limpid::viewer::widgets
