#include "apps/viewer/MethodPanel.h"

#include "apps/viewer/Widgets.h"
#include "scene/MethodFacts.h"

namespace limpid::viewer {

using namespace widgets;

namespace {

void filterFields(int& taps, double& radius, const char* unit) {
    wholeNumber("filter taps", taps, 0, 32, "0: no filter");
    number("filter radius", radius, {.speed = 0.02, .min = 0, .max = 64}, unit);
}

void photonFields(CausticsSettings& caustics) {
    wholeNumbers("photons", caustics.photonGrid, 1, 4096, "cells of a grid over the water");
    int over = int(caustics.photonGridOver);
    if (ImGui::Combo("grid over", &over, "receiver\0water\0"))
        caustics.photonGridOver = static_cast<PhotonGridOver>(over);
    hint("the water that lights a receiver, for each anew, or all water once (paper)");
    wholeNumber("subdivision", caustics.photonSubdivision, 1, 16, "photons along a side of a cell");
    glm::dvec2 size = caustics.splatSize;
    if (vector("splats", size, {.speed = 0.1, .min = 1, .max = 256},
               "texels at the most and at the least water") &&
        size.x <= size.y)
        caustics.splatSize = size;
    filterFields(caustics.filterTaps, caustics.filterRadius, "texels");
}

void planeFields(CausticsSettings& caustics) {
    if (factsOf(caustics.method).fills) {
        int fill = int(caustics.fill);
        if (ImGui::Combo("fill", &fill, "drawn\0one pass\0")) caustics.fill = static_cast<Fill>(fill);
        hint("planes drawn one after another, or beams walked in one pass");
    }
    wholeNumber("planes", caustics.planes, 1, 512, "reference planes of a box, before slicing drops any");
    if (!factsOf(caustics.method).slicing) return;
    int slicing = int(caustics.slicing);
    if (ImGui::Combo("slicing", &slicing, "automatic\0levels (thesis)\0"))
        caustics.slicing = static_cast<Slicing>(slicing);
    if (caustics.slicing != Slicing::Levels) return;
    wholeNumber("depth levels", caustics.depthLevels, 1, 1024);
    number("threshold", caustics.threshold, {.speed = 0.0005, .min = 1e-4, .max = 1}, "of the box's height");
}

/// Why none are seen, if so.
void godraysRemark(const Scene& scene) {
    if (scene.water.scattering == glm::dvec3(0))
        ImGui::TextDisabled("the water scatters nothing: choose its type");
    else if (scene.camera.position->y >= scene.water.level)
        ImGui::TextDisabled("seen by a camera under water only");
}

} // namespace

void methodCombo(const char* label, Method& method) {
    if (!ImGui::BeginCombo(label, std::string(methodName(method)).c_str())) return;
    for (const Method each : allMethods())
        if (ImGui::Selectable(std::string(methodName(each)).c_str(), each == method)) method = each;
    ImGui::EndCombo();
}

void methodSection(State& state) {
    if (!section("Method", true)) return;
    CausticsSettings& caustics = state.scene.caustics;
    methodCombo("method", caustics.method);
    wholeNumber("map size", caustics.mapSize, 16, 8192, "texels on the longer side of a map");
    number("per pixel", caustics.texelsPerPixel, {.speed = 0.01, .min = 0, .max = 64},
           "texels of receivers that are small in the picture, about; 0: as many as elsewhere");
    number("refresh", caustics.refresh, {.speed = 0.2, .min = 0, .max = 1000},
           "caustics a second of the scene's time, at most; 0: as many as pictures");
    if (factsOf(caustics.method).photons)
        photonFields(caustics);
    else if (factsOf(caustics.method).planes)
        planeFields(caustics);
}

void godraysSection(State& state) {
    if (!section("Godrays")) return;
    ImGui::PushID("godrays");
    GodraySettings& godrays = state.scene.godrays;
    int method = int(godrays.method);
    if (ImGui::Combo("method", &method, "none\0photon lines\0exact shafts\0tetrahedra\0"))
        godrays.method = static_cast<GodrayMethod>(method);
    hint("how light is drawn that the water scatters");
    if (godrays.method != GodrayMethod::None) {
        godraysRemark(state.scene);
        int phase = int(godrays.phase);
        if (ImGui::Combo("phase", &phase, "Henyey-Greenstein\0Schlick\0"))
            godrays.phase = static_cast<Phase>(phase);
        wholeNumbers("grid", godrays.grid, 1, 2048, "cells over the water");
        wholeNumber("subdivision", godrays.subdivision, 1, 16,
                    "lines, rays or volumes along a side of a cell");
        number("scale", godrays.scale, {.speed = 0.005, .min = 0.01, .max = 1},
               "sides of what they are drawn into, of the picture's");
        if (godrays.method == GodrayMethod::PhotonLines) {
            number("line width", godrays.lineWidth, {.speed = 0.02, .min = 0.5, .max = 256},
                   "pixels of that");
        } else if (godrays.method == GodrayMethod::Tetrahedra) {
            wholeNumber("sub-volumes", godrays.subVolumes, 0, 256,
                        "along each volume of light; 0: as many as the water asks for");
        } else {
            wholeNumber("planes", godrays.planes, 1, 1024, "along the light, between which it is summed");
            wholeNumber("steps", godrays.steps, 1, 4096, "of a view ray through them");
        }
        filterFields(godrays.filterTaps, godrays.filterRadius, "pixels of that");
    }
    ImGui::PopID();
}

} // namespace limpid::viewer
