#include "apps/viewer/MethodPanel.h"

#include "apps/viewer/KeyFields.h"

namespace limpid::viewer {

using namespace widgets;

namespace {

/// Why none are seen, if so.
void godraysRemark(const Scene& scene) {
    if (scene.godrays.method == GodrayMethod::None) return;
    if (scene.water.scattering == glm::dvec3(0))
        ImGui::TextDisabled("the water scatters nothing: choose its type");
    else if (scene.camera.position->y >= scene.water.level)
        ImGui::TextDisabled("seen by a camera under water only");
}

} // namespace

void methodField(Method& method) {
    keyField(keyOf(causticsKeys, &CausticsSettings::method), method, 0);
}

void methodSection(State& state) {
    if (!section("Method", true)) return;
    CausticsSettings& caustics = state.scene.caustics;
    const glm::dvec2 splats = caustics.splatSize;
    keyFields(causticsKeys, caustics, 0, [](const auto&) { return false; });
    if (caustics.splatSize.x > caustics.splatSize.y) caustics.splatSize = splats;
}

void godraysSection(State& state) {
    if (!section("Godrays")) return;
    ImGui::PushID("godrays");
    GodraySettings& godrays = state.scene.godrays;
    keyFields(godrayKeys, godrays, 0, [&](const auto& key) {
        if (!key.is(&GodraySettings::method)) return false;
        keyField(key, godrays.method, 0);
        godraysRemark(state.scene);
        return true;
    });
    ImGui::PopID();
}

} // namespace limpid::viewer
