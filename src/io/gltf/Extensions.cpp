#include "io/gltf/Extensions.h"

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "io/Files.h"

namespace limpid::io {

namespace {

struct Extension {
    std::string_view name;
    std::string_view unused; ///< the reason why it is not used, or not in full
};

/// What a file may require: used, or without a say in where light goes.
constexpr Extension honoured[] = {
    {"KHR_draco_mesh_compression", ""},
    {"EXT_meshopt_compression", ""},
    {"KHR_meshopt_compression", ""},
    {"KHR_mesh_quantization", ""},
    {"EXT_mesh_gpu_instancing", ""},
    {"KHR_lights_punctual", ""},
    {"KHR_node_visibility", ""},
    {"KHR_texture_transform", ""},
    {"KHR_materials_emissive_strength", ""},
    {"KHR_materials_transmission", ""},
    {"KHR_materials_pbrSpecularGlossiness", mattReason},
    {"KHR_materials_anisotropy", mattReason},
    {"KHR_materials_clearcoat", mattReason},
    {"KHR_materials_ior", mattReason},
    {"KHR_materials_iridescence", mattReason},
    {"KHR_materials_sheen", mattReason},
    {"KHR_materials_specular", mattReason},
    {"KHR_materials_unlit", "all surfaces are lit"},
    {"KHR_materials_variants", "the file's default materials are drawn"},
    {"KHR_xmp_json_ld", ""},
};

/// What others are for, so that the reason can be told.
constexpr Extension others[] = {
    {"KHR_materials_diffuse_transmission", "no light is scattered through a surface"},
    {"KHR_materials_dispersion", "light goes straight through what it goes through"},
    {"KHR_materials_volume", "light goes straight through what it goes through"},
    {"KHR_materials_volume_scatter", "light goes straight through what it goes through"},
    {"KHR_animation_pointer", "animations are not played"},
    {"KHR_texture_basisu", "KTX2 pictures are not read"},
    {"EXT_texture_avif", "AVIF pictures are not read"},
    {"EXT_texture_webp", "WebP pictures are not read"},
    {"MSFT_texture_dds", "DDS pictures are not read"},
    {"EXT_lights_ies", "lights shine as the core of their entry says"},
    {"EXT_lights_image_based", "the scene's sky and ambient light stand for it"},
    {"MSFT_lod", "the node's own mesh is drawn"},
};

const Extension* find(std::span<const Extension> list, std::string_view name) {
    const auto found =
        std::find_if(list.begin(), list.end(), [&](const Extension& e) { return e.name == name; });
    return found == list.end() ? nullptr : &*found;
}

} // namespace

void checkRequiredExtensions(const GltfFile& file) {
    for (const std::string& extension : file.model.extensionsRequired) {
        if (find(honoured, extension)) continue;
        std::vector<std::string_view> names;
        for (const Extension& each : honoured)
            names.push_back(each.name);
        file.fail("extensionsRequired", fmt::format("{}", fmt::join(names, ", ")),
                  fmt::format("\"{}\" ({})", oneLine(extension, 80), unusedReason(extension)));
    }
}

std::string_view unusedReason(std::string_view extension) {
    const Extension* known = find(honoured, extension);
    if (!known) known = find(others, extension);
    return known ? known->unused : "it is not known";
}

} // namespace limpid::io
