// A receiver lit by one of its caustic maps (thesis 4.6, eq. 4-19; further lights are added, eq. 4-20).
// Out 0, RGBA16F: radiance that leaves the receiver, W/(m² sr); alpha 1.
// Out 1, RGBA32F: position, m from the scene's origin; metres of water between it and the surface along the view
//        ray (from the camera itself if that is below).
#include "include/box.glsl"
#include "include/view.glsl"
#include "include/receiver_fragment.glsl"
layout(binding = 1) uniform sampler2D castMap;
layout(location = 0) uniform int underwater;
layout(location = 1) uniform int withAmbient;  // once for each receiver
layout(location = 2) uniform int withCaustics; // castMap and BoxFrame are bound
layout(location = 3) uniform vec3 directIrradiance; // above the water: W/m² facing the light
layout(location = 4) uniform vec3 directDirection;  // unit, the way that light travels
layout(location = 0) out vec4 outRadiance;
layout(location = 1) out vec4 outPosition;

const float pi = 3.14159265358979;

// Irradiance at this point from the four nearest texels that show the same surface, W/m².
vec3 castIrradiance(vec3 faceNormal) {
    vec3 q = boxLocal(fragmentIn.position);
    vec2 at = q.xy / boxExtent.w - 0.5;
    vec2 base = floor(at), part = at - base;
    // A steep face spans more depth a texel; the bound keeps light from creeping around edges.
    float facing = max(abs(dot(faceNormal, boxT.xyz)), 0.25);
    float slack = boxExtent.w * (2.0 + 2.0 * sqrt(1.0 - facing * facing) / facing);
    vec3 sum = vec3(0.0);
    float weights = 0.0, all = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 texel = clamp(ivec2(base) + ivec2(i & 1, i >> 1), ivec2(0), boxSize.xy - 1);
        vec4 stored = texelFetch(castMap, texel, 0);
        float weight = ((i & 1) == 0 ? 1.0 - part.x : part.x) * (i < 2 ? 1.0 - part.y : part.y);
        // What the light meets behind this point is no shade on it: the receiver is thinner there than a texel.
        bool same = stored.w >= 0.0 && stored.w > q.z - slack;
        all += weight;
        if (!same) continue;
        sum += weight * stored.rgb;
        weights += weight;
    }
    return weights > 0.25 * all ? sum / weights : sum;
}

void main() {
    vec3 position = fragmentIn.position;
    if (underwater != 0 ? position.y > viewWater.x : position.y < viewWater.x) discard;
    vec3 seenAt = underwater != 0 && cameraAbove() ? viewCrossing(position) : cameraPosition.xyz;
    vec3 view = seenAt - position;
    vec3 face = fragmentIn.faceNormal;
    vec3 shading = length(fragmentIn.normal) > 0.0 ? normalize(fragmentIn.normal) : face;
    if (dot(shading, face) < 0.0) shading = -shading;

    vec3 irradiance = vec3(0.0);
    if (withCaustics != 0) {
        float facing = -dot(face, boxT.xyz);
        // The light falls on one side of a sheet only.
        bool lit = dot(face, view) * facing > 0.0;
        // Flux goes by the face, the look by the shading normal.
        float smoothing = clamp(-dot(shading, boxT.xyz) / (sign(facing) * max(abs(facing), 0.05)), 0.0, 1.5);
        if (lit) irradiance = castIrradiance(face) * smoothing;
    }
    irradiance += directIrradiance * max(-dot(shading, directDirection), 0.0);
    vec3 albedo = baseColor().rgb;
    vec3 radiance = albedo / pi * irradiance + (withAmbient != 0 ? albedo * ambientRadiance.rgb : vec3(0.0));
    outRadiance = vec4(radiance, 1.0);
    outPosition = vec4(position, distance(position, seenAt));
}
