// The camera and what it sees everything through. Positions in m from the scene's origin, radiance in W/(m² sr).
#include "include/optics.glsl"
layout(std140, binding = 2) uniform ViewFrame {
    mat4 viewProjection;
    vec4 cameraPosition; // w: 1 above the water, 0 below
    vec4 ambientRadiance;
    vec4 skyRadiance;
    vec4 waterExtinction; // RGB, 1/m; w: an upper bound on m of water along a view ray to any receiver
    vec4 viewWater;       // level, m; index of refraction; scale of the underwater view (its margin)
    vec4 deepRadiance;    // what endless water looks like
};

// Radiance that is left of `radiance` after `metres` of water, with what the water adds on the way.
vec3 throughWater(vec3 radiance, float metres) {
    vec3 left = extinction(waterExtinction.rgb, metres);
    return radiance * left + deepRadiance.rgb * (1.0 - left);
}

bool cameraAbove() { return cameraPosition.w > 0.5; }

// Where a view ray to `point` (below the level) crosses the flat surface.
vec3 viewCrossing(vec3 point) {
    float above = cameraPosition.y - viewWater.x;
    vec2 away = point.xz - cameraPosition.xz;
    float across = length(away);
    float x = flatCrossing(above, max(viewWater.x - point.y, 0.0), across, viewWater.y);
    vec2 at = cameraPosition.xz + (across > 0.0 ? away * (x / across) : vec2(0.0));
    return vec3(at.x, viewWater.x, at.y);
}

// Clip coordinates in the underwater view: through the flat surface if the camera is above it. Depth is by metres
// of water.
vec4 underwaterClip(vec3 point) {
    // What stands out of the water is seen straight, and a triangle through the surface does not kink there.
    vec3 seenAt = cameraAbove() && point.y < viewWater.x ? viewCrossing(point) : point;
    vec4 clip = viewProjection * vec4(seenAt, 1.0);
    float metres = distance(point, cameraAbove() ? seenAt : cameraPosition.xyz);
    return vec4(clip.xy * viewWater.z, 1.8 * (metres / waterExtinction.w - 0.5) * clip.w, clip.w);
}
