#version 450 core
// A matt surface in the light of its caustic maps.
#include "limpid_caustics.glsl"
in vec3 position; // m, in the world
in vec3 normal;
layout(location = 2) uniform vec3 albedo;
layout(location = 3) uniform vec3 eye; // m
layout(location = 4) uniform int mapCount;
layout(location = 8) uniform mat4 worldToTexture[5]; // of a sun: one along its light, four for faces along it
layout(binding = 0) uniform sampler2D irradiances[5];
layout(binding = 5) uniform sampler2D positions[5];
layout(binding = 10) uniform sampler2D normals[5];
layout(location = 0) out vec4 color;

const float pi = 3.14159265;

void main() {
    vec3 face = cross(dFdx(position), dFdy(position));
    if (dot(face, eye - position) < 0.0) face = -face;
    vec3 irradiance = vec3(0.0);
    for (int i = 0; i < mapCount; ++i) {
        vec3 light = limpidIrradiance(irradiances[i], positions[i], normals[i], worldToTexture[i], position, face);
        // Maps hold light on flat faces; the shading normal smooths it.
        vec3 along = vec3(worldToTexture[i][0].z, worldToTexture[i][1].z, worldToTexture[i][2].z);
        irradiance += light * clamp(dot(normal, along) * length(face) / min(dot(face, along), -1e-6), 0.0, 1.5);
    }
    vec3 radiance = albedo * (irradiance / pi + 0.05);
    color = vec4(pow(radiance / (1.0 + radiance), vec3(1.0 / 2.2)), 1.0);
}
