#include "io/toml/KeyReader.h"

namespace limpid::io {

namespace {

/// Whole numbers of a range, as TOML has them.
template <std::size_t N>
std::array<std::int64_t, N> readWholes(TomlTable& table, const KeyRow& key,
                                       std::array<std::int64_t, N> values) {
    const auto min = std::int64_t(key.range().min), max = std::int64_t(key.range().max);
    if (N == 1)
        table.wholeNumber(key.name, values[0], min, max);
    else
        table.wholeNumbers(key.name, values, min, max);
    return values;
}

} // namespace

void readKey(TomlTable& table, const KeyRow& key, double& value) {
    table.number(key.name, value, key.range());
}

void readKey(TomlTable& table, const KeyRow& key, int& value) {
    value = int(readWholes<1>(table, key, {value})[0]);
}

void readKey(TomlTable& table, const KeyRow& key, std::uint32_t& value) {
    value = std::uint32_t(readWholes<1>(table, key, {value})[0]);
}

void readKey(TomlTable& table, const KeyRow& key, glm::ivec2& value) {
    const auto numbers = readWholes<2>(table, key, {value.x, value.y});
    value = {int(numbers[0]), int(numbers[1])};
}

void readKey(TomlTable& table, const KeyRow& key, glm::dquat& value) {
    glm::dvec4 turn(value.x, value.y, value.z, value.w);
    readKey(table, key, turn);
    value = glm::normalize(glm::dquat(turn.w, turn.x, turn.y, turn.z));
}

void readKey(TomlTable& table, const KeyRow& key, std::string& value) {
    table.text(key.name, value, key.text().expected);
}

void readKey(TomlTable& table, const KeyRow& key, std::span<double> values) {
    const toml::node* node = table.value(key.name);
    if (key.range().square && node && node->is_number()) {
        table.number(key.name, values[0], key.range());
        std::fill(values.begin(), values.end(), values[0]);
        return;
    }
    table.numbers(key.name, values, key.range());
    double square = 0;
    for (const double value : values)
        square += value * value;
    if (node && key.range().direction && !(square > 1e-24)) table.fail(key.name, "a vector of a length > 0");
}

} // namespace limpid::io
