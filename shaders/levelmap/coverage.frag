// Whether a place of a level map shows the same surface as its texel's middle.
// In: position and normal map. Out, R8: 1 (cleared to 0: no receiver).
#include "interface/bindings.glsl"
#include "levelmap/level_map_texel.glsl"
#include "optics/octahedral.glsl"
#include "levelmap/same_surface.glsl"
layout(binding = positionMapUnit) uniform sampler2D positionMap; // RG32F (level_map.frag)
layout(binding = normalMapUnit) uniform sampler2D normalMap;     // RG16
out float outCovered;

// Whether the face at `local` lies where the one at the texel's middle goes on to, give or take what a crease in between
// can make. What else a texel holds, behind a rim or beyond a crease, has no light of its own in the map.
bool showsMiddle(vec3 local) {
    vec2 place = local.xy / boxExtent.w;
    ivec2 texel = ivec2(place);
    if (any(lessThan(place, vec2(0.0))) || any(greaterThanEqual(texel, boxSize.xy))) return false;
    vec2 position = texelFetch(positionMap, texel, 0).xy;
    if (position.y == -1.0) return false;
    vec2 own = depthGradient(octahedralDecode(texelFetch(normalMap, texel, 0).xy));
    float crease = distance(own, depthGradient(fragmentIn.faceNormal));
    float expected = position.x + dot(own, place - vec2(texel) - 0.5) * boxExtent.w;
    return crease <= mostCrease && abs(local.z - expected) <= creaseSlack(crease);
}

void main() {
    if (!isInMap()) discard;
    outCovered = showsMiddle(boxLocal(fragmentIn.position)) ? 1.0 : 0.0;
}
