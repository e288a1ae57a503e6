// What the lit water sends to the camera: a march along the view to what ends it, with steps that each take as much of
// what would be left of an even light.
// In: layers of lit water (shaft_deposit.comp), depth of the view, the scene depth map of the light.
// Out, RGBA32F, added: W/(m² sr).
#include "interface/bindings.glsl"
#include "godrays/godray_phase.glsl"
#include "levelmap/scene_depth.glsl"
#include "interface/shaft_gap.glsl"
layout(std430, binding = gapsBuffer) readonly buffer Gaps { Gap gaps[]; };
layout(binding = litUnit) uniform sampler2DArray lit;
layout(binding = viewDepthUnit) uniform sampler2D viewDepth; // 1 at the near plane, 0 far away
layout(location = evenGapsLocation) uniform int evenGaps;          // that are `gapHeight` thick
layout(location = gapCountLocation) uniform int gapCount;
layout(location = gapHeightLocation) uniform float gapHeight; // m
layout(location = gapGrowthLocation) uniform float gapGrowth; // of one below those to the next
layout(location = stepCountLocation) uniform int stepCount;
layout(location = nearLocation) uniform float near; // m
layout(location = meanLostLocation) uniform float meanLost; // 1/m, of the channels
layout(location = fanLocation) uniform vec4 fan; // x, z that light spreads from; 1 over its height over the level; slope at most
out vec4 radiance;

int gapOf(float depth) {
    float i = depth / gapHeight, even = float(evenGaps);
    if (i > even) i = even + log(1.0 + (i - even) * (gapGrowth - 1.0) / gapGrowth) / log(gapGrowth);
    return clamp(int(i), 0, gapCount - 1);
}

// How far aside the mean light goes by metre of depth, at a point.
vec2 lightSlope(vec2 at, float depth) {
    if (!isPointLight()) return lightRefracted.xz / -lightRefracted.y;
    vec2 slope = (at - fan.xy) / (1.0 / fan.z + depth);
    return slope * min(1.0, fan.w / max(length(slope), 1e-9));
}

// The mean light's share that is scattered into a way, 1/sr. `slope` of the light, `longer` by which its path is longer
// than straight down.
float meanScattered(vec3 way, vec2 slope, float longer) {
    return scatteredTowards(dot(way, vec3(slope.x, -1.0, slope.y)) / longer);
}

// Of a view ray here and a metre of it: before strength, scattering and extinction.
float litAt(vec3 point, vec3 way, float depth, vec2 slope, float longer) {
    int i = gapOf(depth);
    vec4 rect = gaps[i].rect, gap = gaps[i].depth;
    // What ended within this gap went on to its bottom.
    float behind = -beforeFirst(point).x;
    if (behind > 0.0 && behind < longer * (depth - gap.x)) return 0.0;
    vec2 at = point.xz + slope * (gap.y - depth);
    float there = textureLod(lit, vec3((at - rect.xy) / rect.zw, float(i)), 0.0).x;
    // A layer has what its own places send to the camera: of a view ray that passes them above or below, next to the
    // camera, that is another way.
    vec3 toPlace = vec3(at.x, waterSurface.x - gap.y, at.y) - cameraPosition.xyz;
    float apart = meanScattered(-way, slope, longer) /
                  meanScattered(-toPlace * inversesqrt(max(dot(toPlace, toPlace), 1e-12)), slope, longer);
    return there * clamp(apart, 0.25, 4.0);
}

void main() {
    vec2 onTarget = 2.0 * gl_FragCoord.xy / target.xy - 1.0;
    vec3 row0 = vec3(viewProjection[0].x, viewProjection[1].x, viewProjection[2].x);
    vec3 row1 = vec3(viewProjection[0].y, viewProjection[1].y, viewProjection[2].y);
    vec3 ahead = vec3(viewProjection[0].w, viewProjection[1].w, viewProjection[2].w);
    vec3 way = ahead + row0 * (onTarget.x / dot(row0, row0)) + row1 * (onTarget.y / dot(row1, row1));
    float seen = texelFetch(viewDepth, ivec2(gl_FragCoord.xy), 0).x, slant = length(way);
    way /= slant;
    float end = seen > 0.0 ? near * slant / seen : 1e9;
    // Nothing is lit below the last gap, nor above the highest crest.
    float deepest = gaps[gapCount - 1].depth.z, eye = waterSurface.x - cameraPosition.y;
    if (way.y < 0.0) end = min(end, (deepest - eye) / -way.y);
    if (way.y > 0.0) end = min(end, (eye + gapHeight) / way.y);
    float taken = 1.0 - exp(-meanLost * end);
    vec3 sum = vec3(0.0);
    float from = 0.0;
    for (int i = 0; i < stepCount; ++i) {
        float to = meanLost * end > 1e-3 ? -log(1.0 - taken * float(i + 1) / float(stepCount)) / meanLost
                                         : end * float(i + 1) / float(stepCount);
        to = min(to, end);
        float middle = 0.5 * (from + to);
        vec3 point = cameraPosition.xyz + middle * way;
        float depth = max(waterSurface.x - point.y, 0.0);
        vec2 slope = lightSlope(point.xz, depth);
        float longer = sqrt(1.0 + dot(slope, slope));
        float here = litAt(point, way, depth, slope, longer) * (to - from);
        if (here > 0.0) sum += here * extinction(extinctionPerMetre.rgb, longer * depth + middle);
        from = to;
    }
    radiance = vec4(strength.rgb * scattering.rgb * sum, 0.0);
}
