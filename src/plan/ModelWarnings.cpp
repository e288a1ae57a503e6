#include "plan/ModelWarnings.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "plan/Facings.h"
#include "plan/WaveTerms.h"
#include "scene/WaterNames.h"

namespace limpid {

namespace {

/// The part of a node that may stand for water: its triangles of clear materials, or of those that water
/// names.
struct Suspect {
    const MeshNode* node = nullptr;
    const Material* material = nullptr; ///< of the first of them
    Mesh mesh{};                        ///< their corners, in the receiver's space
};

/// Files often blend what hides all behind it.
bool hasLowAlpha(const Mesh& mesh, const Material& material) {
    if (material.baseColor.a < 1) return true;
    if (std::any_of(mesh.colors.begin(), mesh.colors.end(), [](const glm::vec4& c) { return c.a < 1; }))
        return true;
    if (material.baseColorImage < 0) return false;
    const std::vector<std::uint8_t>& rgba = mesh.images[std::size_t(material.baseColorImage)].rgba;
    for (std::size_t alpha = 3; alpha < rgba.size(); alpha += 4)
        if (rgba[alpha] < 255) return true;
    return false;
}

bool isClear(const Mesh& mesh, const Material& material) {
    return material.transmission > 0 ||
           (material.alphaMode == AlphaMode::Blend && hasLowAlpha(mesh, material));
}

const MeshNode* nodeOf(const Mesh& mesh, std::uint32_t vertex) {
    const auto next = std::upper_bound(mesh.nodes.begin(), mesh.nodes.end(), vertex,
                                       [](std::uint32_t v, const MeshNode& n) { return v < n.firstVertex; });
    return next == mesh.nodes.begin() ? nullptr : &*std::prev(next);
}

/// By node, in the order of their vertices.
std::map<std::uint32_t, Suspect> suspectsOf(const Mesh& mesh) {
    std::map<std::uint32_t, Suspect> suspects;
    for (const MeshPart& part : mesh.parts) {
        const Material& material = mesh.materials[std::size_t(part.material)];
        if (!isClear(mesh, material) && !namesWater(material.name)) continue;
        for (std::uint32_t i = part.firstIndex; i < part.firstIndex + part.indexCount; ++i) {
            const MeshNode* node = nodeOf(mesh, mesh.indices[i]);
            if (!node) continue; // a shape's
            Suspect& suspect = suspects[node->firstVertex];
            if (!suspect.node) suspect = {node, &material};
            suspect.mesh.indices.push_back(std::uint32_t(suspect.mesh.positions.size()));
            suspect.mesh.positions.push_back(mesh.positions[mesh.indices[i]]);
        }
    }
    for (const MeshNode& node : mesh.nodes)
        if (node.vertexCount > 0 && (namesWater(node.name) || namesWater(node.meshName)))
            suspects[node.firstVertex].node = &node;
    return suspects;
}

/// The name by which a receiver's key `without` leaves it out; empty if it has none.
const std::string& nameOf(const Suspect& suspect, bool water) {
    const auto fits = [&](const std::string& name) { return water ? namesWater(name) : !name.empty(); };
    if (fits(suspect.node->name)) return suspect.node->name;
    const bool byMesh = fits(suspect.node->meshName) || !suspect.material;
    return byMesh ? suspect.node->meshName : suspect.material->name;
}

/// A flat one whose height the surface may have.
bool isSheetAtLevel(const Bounds& bounds, const Water& water) {
    const glm::dvec3 size = bounds.size();
    const double width = std::max(size.x, size.z);
    const double reach = highestWave(water) + 0.01 * width;
    return size.y <= 0.05 * width && bounds.min.y <= water.level + reach &&
           bounds.max.y >= water.level - reach;
}

Bounds worldBoundsOf(const Suspect& suspect, const Receiver& receiver) {
    Bounds bounds;
    for (const glm::dvec3& p : suspect.mesh.positions)
        bounds.add(receiver.toWorld(p));
    return bounds;
}

constexpr const char* byName = "water by its name";
constexpr const char* sheet = "a clear sheet at the water's level";
constexpr const char* body = "a closed clear body in the water, in which nothing refracts";

/// Null for what is none of these.
const char* kindOf(const Suspect& suspect, const Receiver& receiver, const Water& water) {
    if (namesWater(suspect.node->name) || namesWater(suspect.node->meshName) ||
        (suspect.material && namesWater(suspect.material->name)))
        return byName;
    const Bounds bounds = worldBoundsOf(suspect, receiver);
    if (isSheetAtLevel(bounds, water)) return sheet;
    return bounds.min.y < water.level && isClosed(suspect.mesh) ? body : nullptr;
}

bool isControl(char c) {
    return static_cast<unsigned char>(c) < ' ' || c == '\x7f';
}

/// Fit for one line.
std::string quoted(std::string name) {
    std::replace_if(name.begin(), name.end(), isControl, ' ');
    return fmt::format("\"{}\"", name);
}

/// A pattern that stands for `name`, as a TOML string.
std::string patternOf(const std::string& name) {
    std::string text;
    for (const char c : name) {
        if (c == '\\') text += "\\\\\\";
        if (std::string_view("*?[").find(c) != std::string_view::npos) text += "\\\\";
        if (c == '"') text += '\\';
        text += isControl(c) ? '?' : c;
    }
    return fmt::format("\"{}\"", text);
}

void addOnce(std::vector<std::string>& list, const std::string& text) {
    if (std::find(list.begin(), list.end(), text) == list.end()) list.push_back(text);
}

/// Names of what is of one kind, and the patterns that leave it out.
struct Found {
    std::vector<std::string> names, patterns;
};

} // namespace

std::vector<std::string> modelWarnings(const Receiver& receiver, const Water& water) {
    std::map<std::string, Found> all; ///< by kind
    for (const auto& [first, suspect] : suspectsOf(*receiver.mesh))
        if (const char* kind = kindOf(suspect, receiver, water)) {
            const std::string& name = nameOf(suspect, kind == byName);
            addOnce(all[kind].names, name.empty() ? "a node without a name" : quoted(name));
            if (!name.empty()) addOnce(all[kind].patterns, patternOf(name));
        }
    std::vector<std::string> warnings;
    for (const auto& [kind, found] : all) {
        std::string line = fmt::format("receiver.{}: expected no water but the scene's own, found {} ({})",
                                       receiver.name, fmt::join(found.names, ", "), kind);
        if (!found.patterns.empty())
            line +=
                fmt::format("; without = [{}] of the receiver leaves it out (--without, of a model alone)",
                            fmt::join(found.patterns, ", "));
        warnings.push_back(std::move(line));
    }
    return warnings;
}

} // namespace limpid
