#pragma once
#include "io/toml/TomlReader.h"

/// Reads keys as their rows say (scene/Keys.h). Each read leaves its target as it is if the key is absent,
/// and throws InputError as TomlTable does.
namespace limpid::io {

void readKey(TomlTable& table, const KeyRow& key, double& value);
void readKey(TomlTable& table, const KeyRow& key, int& value);
void readKey(TomlTable& table, const KeyRow& key, std::uint32_t& value);
void readKey(TomlTable& table, const KeyRow& key, glm::ivec2& value);
void readKey(TomlTable& table, const KeyRow& key, glm::dquat& value); ///< comes out as a unit
void readKey(TomlTable& table, const KeyRow& key, std::string& value);
/// A list, one number for all of it, or a direction, as the row says; comes out as it went in.
void readKey(TomlTable& table, const KeyRow& key, std::span<double> values);

template <int N>
void readKey(TomlTable& table, const KeyRow& key, glm::vec<N, double>& value) {
    readKey(table, key, std::span<double>(&value[0], N));
}

template <typename T>
void readKey(TomlTable& table, const KeyRow& key, std::optional<T>& value) {
    if (table.has(key.name)) readKey(table, key, value.emplace());
}

template <typename T>
requires std::is_enum_v<T>
void readKey(TomlTable& table, const KeyRow& key, T& value) {
    auto index = std::size_t(value);
    table.choice(key.name, index, key.choice());
    value = T(index);
}

/// All members of a section that `object` knows.
template <typename S>
void readKeys(TomlTable& table, std::span<const Key<S>> keys, S& object) {
    for (const Key<S>& key : keys) {
        if (!knows(object, key)) continue;
        std::visit(
            [&]<typename M>(M member) {
                if constexpr (!std::is_same_v<M, std::monostate>) readKey(table, key, object.*member);
            },
            key.member);
    }
}

} // namespace limpid::io
