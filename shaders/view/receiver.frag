// A receiver lit by one of its caustic maps (thesis 4.6, eq. 4-19; further lights are added, eq. 4-20).
// Out 0, RGBA32F: radiance that leaves the receiver, W/(m² sr), times alpha; alpha, 1 for what is not blended.
// Out 1, R32F: metres from where it is seen: the camera, its mirror image, or where the view ray crosses the surface.
#include "interface/bindings.glsl"
#include "levelmap/facing.glsl"
#include "view/water_height.glsl"
#include "levelmap/receiver_fragment.glsl"
#include "water/surface_shadow.glsl"
#include "levelmap/point_light_shadow.glsl"
layout(binding = castMapUnit) uniform sampler2D castMap;
layout(location = underwaterLocation) uniform int underwater; // 1: shows what is below the surface, 0: what is above it
layout(location = withAmbientLocation) uniform int withAmbient; // once for each receiver
layout(location = withCausticsLocation) uniform int withCaustics; // castMap and BoxFrame are bound
layout(location = strengthLocation) uniform vec3 strength; // of a light that comes straight, W/m² or W/sr; LightFrame is bound
layout(location = wayLocation) uniform int way; // straight, refracted or mirrored
layout(location = blendedSideLocation) uniform int blendedSide; // 0: what hides all behind it; of what is blended with that, 1: faces
                                               // seen from the front, -1: from the back
layout(location = transmissionLocation) uniform float transmission; // of what is blended
layout(location = ofPartlyBlendedLocation) uniform int ofPartlyBlended; // 1: maps show not this, but what is behind it (scene/Mesh.h)
layout(location = radianceTarget) out vec4 outRadiance;
layout(location = metresTarget) out float outMetres;

layout(binding = normalTextureUnit) uniform sampler2D normalTexture;     // tangent space, glTF
layout(binding = pointLightShadowUnit) uniform sampler2D pointLightShadow;           // of a point light under water
layout(binding = emissionTextureUnit) uniform sampler2D emissionTexture; // sRGB, white where the material has none

const float solidAlpha = 254.5 / 255.0; // as in levelmap/ReceiverGeometry.h
const float pi = 3.14159265358979;

// Interpolated normal, turned by the normal map. Tangents come from how position and uv change over the screen
// (Mikkelsen 2010), which needs none in the file.
vec3 shadingNormal(vec3 face) {
    vec3 normal = length(fragmentIn.normal) > 0.0 ? normalize(fragmentIn.normal) : face;
    if (dot(normal, face) < 0.0) normal = -normal;
    vec3 px = dFdx(fragmentIn.position), py = dFdy(fragmentIn.position);
    vec2 tx = dFdx(fragmentIn.uv.zw), ty = dFdy(fragmentIn.uv.zw);
    vec3 acrossX = cross(py, normal), acrossY = cross(normal, px);
    float orientation = sign(dot(px, acrossX));
    vec3 tangent = (acrossX * tx.x + acrossY * ty.x) * orientation;
    vec3 bitangent = (acrossX * tx.y + acrossY * ty.y) * orientation;
    float size = max(dot(tangent, tangent), dot(bitangent, bitangent));
    if (normalScale == 0.0) return normal;
    vec3 mapped = 2.0 * texture(normalTexture, fragmentIn.uv.zw).xyz - 1.0;
    if (!(size > 0.0)) return normal;
    // glTF's v runs down the picture, its bitangent up.
    vec3 turned = (tangent * mapped.x - bitangent * mapped.y) * (normalScale / sqrt(size)) + normal * mapped.z;
    return dot(turned, turned) > 0.0 ? normalize(turned) : normal;
}

// Irradiance at this point from the four nearest texels that show the same surface, W/m².
vec3 castIrradiance(vec3 faceNormal) {
    // Maps end at the level; what a crest covers above it is lit as just below.
    vec3 q = boxLocal(vec3(fragmentIn.position.x, min(fragmentIn.position.y, waterRest.x), fragmentIn.position.z));
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

// Irradiance by a light that crosses no surface on its way, W/m².
vec3 straightIrradiance(vec3 normal, vec3 face) {
    vec3 position = fragmentIn.position;
    vec3 direction = incidentDirection(position);
    float metres = isPointLight() ? distance(position, lightPosition.xyz) : 0.0;
    vec3 arriving = strength * (isPointLight() ? intensityShare(position) / max(metres * metres, 1e-12) : 1.0);
    if (underwater != 0) arriving *= extinction(waterExtinction.rgb, metres);
    if (underwater != 0) return arriving * pointLightVisibility(pointLightShadow, position, face) * max(-dot(normal, direction), 0.0);
    float footprint = max(surfaceShadowRect.z, surfaceShadowRect.w) / float(textureSize(surfaceShadow, 0).x);
    return arriving * surfaceVisibility(position, 6.0 * footprint) * max(-dot(normal, direction), 0.0);
}

vec3 emission() { return emissionFactor * texture(emissionTexture, fragmentIn.uv.xy).rgb; }

void main() {
    // All that is a derivative, or a texture whose level comes of one, before a neighbour may be discarded.
    vec4 color = baseColor();
    bool hole = isHole(color);
    vec3 face = fragmentIn.faceNormal, shading = shadingNormal(face);
    vec3 emitted = withAmbient != 0 ? emission() : vec3(0.0);

    vec3 position = fragmentIn.position;
    vec3 view = seenFrom(position, way) - position;
    // What is looked up next to a waterline must find the object there, so views overlap it by a few texels.
    float overlap = way == straight ? 0.0 : 4.0 * viewWater.w * distance(position, cameraPosition.xyz);
    float over = position.y - waterHeight(position.xz);
    if (hole || (underwater != 0 ? over > overlap : over < -overlap)) discard;
    float turned = dot(face, view) < 0.0 ? -1.0 : 1.0;
    // A sheet shows what is behind it by what it lets through (scene/Mesh.h, transmittance), in the mean of its colours; what
    // is transmissive of it scatters nothing.
    vec4 base = blendedSide != 0 ? clamp(color, 0.0, 1.0) : vec4(color.rgb, 1.0);
    float through = blendedSide != 0 ? transmission : 0.0;
    vec3 taken = base.a * (1.0 - through * base.rgb);
    float alpha = dot(taken, vec3(1.0 / 3.0));
    if (blendedSide != 0 && (turned != float(blendedSide) || alpha >= solidAlpha)) discard;

    vec3 irradiance = vec3(0.0);
    if (withCaustics != 0) {
        float facing = -dot(face, boxT.xyz);
        // The light falls on one side of a sheet only.
        bool lit = dot(face, view) * facing > 0.0;
        // Flux goes by the face, the look by the shading normal.
        float smoothing = clamp(-dot(shading, boxT.xyz) / (sign(facing) * max(abs(facing), 0.05)), 0.0, 1.5);
        lit = lit && belongsToMap(face);
        // Maps hold what the surface takes, or what it lets through; its colour shows by all that comes to it.
        vec3 held = blendedSide != 0 && ofPartlyBlended != 0 ? 1.0 - taken : taken;
        if (lit) irradiance = castIrradiance(face) * smoothing / max(held, vec3(0.02));
    }
    if (strength != vec3(0.0)) irradiance += straightIrradiance(turned * shading, face);
    vec3 albedo = base.rgb * (base.a * (1.0 - through) / max(alpha, 1e-3));
    vec3 radiance = albedo / pi * irradiance + (withAmbient != 0 ? albedo * ambientRadiance.rgb : vec3(0.0));
    vec3 glow = base.a * emitted;
    if (underwater != 0 && way == straight) {
        vec3 left = extinction(waterExtinction.rgb, length(view));
        radiance = radiance * left + (withAmbient != 0 ? deepRadiance.rgb * (1.0 - left) : vec3(0.0));
        glow *= left;
    }
    outRadiance = vec4(radiance * alpha + glow, withAmbient != 0 ? alpha : 0.0); // once, however many lights add to it
    outMetres = length(view);
}
