#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/Common.h"
#include "apps/EngineUse.h"

namespace limpid::apps {

namespace {

nlohmann::ordered_json infoJson(const gl::DeviceInfo& info) {
    nlohmann::ordered_json json = {{"limpid", LIMPID_VERSION},
                                   {"vendor", info.vendor},
                                   {"renderer", info.renderer},
                                   {"gl", info.version},
                                   {"glsl", info.glsl},
                                   {"egl", info.egl},
                                   {"platform", info.platform},
                                   {"limits",
                                    {{"texture_size", info.maxTextureSize},
                                     {"texture_layers", info.maxTextureLayers},
                                     {"compute_invocations", info.maxComputeInvocations},
                                     {"storage_block_bytes", info.maxStorageBlockBytes},
                                     {"subpixel_bits", info.subpixelBits}}}};
    json["devices"] = nlohmann::ordered_json::array();
    for (const gl::DeviceDescription& device : gl::Context::devices())
        json["devices"].push_back(
            {{"index", device.index}, {"name", device.name}, {"software", device.software}});
    return json;
}

void printInfo(const gl::DeviceInfo& info) {
    fmt::print("limpid    {}\n", LIMPID_VERSION);
    fmt::print("GPU       {} ({})\n", info.renderer, info.vendor);
    fmt::print("OpenGL    {}, GLSL {}\n", info.version, info.glsl);
    fmt::print("EGL       {}, platform {}\n", info.egl, info.platform);
    fmt::print("maps      up to {0} x {0} texels, {1} slices of a volumetric one\n", info.maxTextureSize,
               info.maxTextureLayers);
    fmt::print("buffers   up to {} MiB each\n", info.maxStorageBlockBytes >> 20);
    fmt::print("compute   {} invocations a group (64 are used)\n", info.maxComputeInvocations);
    fmt::print("raster    corners on a grid of 1/{} texel\n", 1 << info.subpixelBits);
    for (const gl::DeviceDescription& device : gl::Context::devices())
        fmt::print("device {}  {}{}\n", device.index, device.name,
                   device.software && device.name != "software" ? " (software)" : "");
}

} // namespace

void addInfo(CLI::App& app) {
    auto* command = app.add_subcommand("info", "GPU, driver, limits, and what is used of them");
    command->footer("Examples:\n  limpid info --json");
    auto json = std::make_shared<bool>(false);
    auto device = std::make_shared<std::string>();
    command->add_flag("--json", *json, "as JSON");
    command->add_option("--device", *device, "EGL device, by number or part of its name");
    command->callback([=] {
        gl::ContextOptions options;
        options.device = *device;
        const gl::Context context(options);
        if (*json)
            fmt::print("{}\n", infoJson(context.info()).dump(2));
        else
            printInfo(context.info());
    });
}

} // namespace limpid::apps
