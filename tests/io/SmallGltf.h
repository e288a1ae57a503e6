#pragma once
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace limpid::test {

/// A glTF file in the making: `json` is free to be changed, and broken, before `text` or `glb` writes it.
struct SmallGltf {
    nlohmann::json json = {{"asset", {{"version", "2.0"}}}};
    std::string bytes; ///< of buffer 0
    nlohmann::json otherBuffers = nlohmann::json::array();

    template <typename T>
    static constexpr int componentType() {
        if constexpr (std::is_same_v<T, std::int8_t>) return 5120;
        if constexpr (std::is_same_v<T, std::uint8_t>) return 5121;
        if constexpr (std::is_same_v<T, std::int16_t>) return 5122;
        if constexpr (std::is_same_v<T, std::uint16_t>) return 5123;
        if constexpr (std::is_same_v<T, std::uint32_t>) return 5125;
        if constexpr (std::is_same_v<T, float>) return 5126;
    }

    /// Adds a buffer view and gives its index.
    int addView(const void* data, std::size_t size) {
        bytes.resize((bytes.size() + 3) / 4 * 4);
        json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", size}});
        bytes.append(static_cast<const char*>(data), size);
        return static_cast<int>(json["bufferViews"].size()) - 1;
    }

    /// Adds tightly packed values with an accessor of their own, and gives its index.
    template <typename T>
    int add(const char* type, const std::vector<T>& values) {
        const std::size_t components =
            std::strcmp(type, "SCALAR") == 0 ? 1 : static_cast<std::size_t>(type[3] - '0');
        return addAccessor({{"bufferView", addView(values.data(), values.size() * sizeof(T))},
                            {"componentType", componentType<T>()},
                            {"count", values.size() / components},
                            {"type", type}});
    }

    int addAccessor(nlohmann::json accessor) {
        json["accessors"].push_back(std::move(accessor));
        return static_cast<int>(json["accessors"].size()) - 1;
    }

    /// Adds a mesh of one primitive with a node that shows it.
    nlohmann::json& addMesh(nlohmann::json primitive) {
        json["nodes"].push_back({{"mesh", json.value("meshes", nlohmann::json::array()).size()}});
        json["meshes"].push_back({{"primitives", {std::move(primitive)}}});
        return json["meshes"].back()["primitives"][0];
    }

    std::string text() const {
        nlohmann::json whole = json;
        if (!bytes.empty() && !whole.contains("buffers"))
            whole["buffers"] = {{{"byteLength", bytes.size()},
                                 {"uri", "data:application/octet-stream;base64," + base64(bytes)}}};
        for (const nlohmann::json& other : otherBuffers)
            whole["buffers"].push_back(other);
        return whole.dump();
    }

    std::string glb() const {
        nlohmann::json whole = json;
        if (!whole.contains("buffers")) whole["buffers"] = {{{"byteLength", bytes.size()}}};
        for (const nlohmann::json& other : otherBuffers)
            whole["buffers"].push_back(other);
        std::string head = whole.dump(), body = bytes;
        head.resize((head.size() + 3) / 4 * 4, ' ');
        body.resize((body.size() + 3) / 4 * 4);
        const std::size_t length = 12 + 8 + head.size() + 8 + body.size();
        return "glTF" + u32(2) + u32(length) + u32(head.size()) + "JSON" + head + u32(body.size()) +
               std::string("BIN\0", 4) + body;
    }

    static std::string u32(std::size_t value) {
        std::string text;
        for (int i = 0; i < 4; ++i)
            text += static_cast<char>(value >> (8 * i));
        return text;
    }

    static std::string base64(const std::string& data) {
        constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        std::string text;
        for (std::size_t i = 0; i < data.size(); i += 3) {
            std::uint32_t group = 0;
            for (std::size_t k = 0; k < 3; ++k)
                group = group << 8 | (i + k < data.size() ? static_cast<unsigned char>(data[i + k]) : 0u);
            for (std::size_t k = 0; k < 4; ++k)
                text += i + k > data.size() ? '=' : digits[group >> (18 - 6 * k) & 63];
        }
        return text;
    }
};

inline const std::vector<float> trianglePositions = {0, 0, 0, 1, 0, 0, 0, 1, 0};

/// One triangle in the xy plane, facing +z, without anything that it does not need.
inline SmallGltf triangleGltf() {
    SmallGltf gltf;
    gltf.addMesh({{"attributes", {{"POSITION", gltf.add("VEC3", trianglePositions)}}}});
    return gltf;
}

} // namespace limpid::test
