// The camera and what it sees everything through. Positions in m from the scene's origin, radiance in W/(m² sr).
// The near side is the camera's own side of the surface, the far side the other one.
#include "optics/optics.glsl"
#include "optics/water_grid.glsl"
#include "interface/view_frame.glsl"

// How receivers come into a view: as they are; through the flat surface, for those on its far side; mirrored in it.
const int straight = 0, refracted = 1, mirrored = 2;

// Radiance that is left of `radiance` after `metres` of water, with what the water adds on the way.
vec3 throughWater(vec3 radiance, float metres) {
    vec3 left = extinction(waterExtinction.rgb, metres);
    return radiance * left + deepRadiance.rgb * (1.0 - left);
}

bool cameraAbove() { return cameraPosition.w > 0.5; }

vec3 mirror(vec3 point) { return vec3(point.x, 2.0 * viewWater.x - point.y, point.z); }

// Where a view ray to `point` on the far side crosses the flat surface.
vec3 viewCrossing(vec3 point) {
    vec3 upper = cameraAbove() ? cameraPosition.xyz : point, lower = cameraAbove() ? point : cameraPosition.xyz;
    vec2 away = lower.xz - upper.xz;
    float across = length(away);
    float x = flatCrossing(upper.y - viewWater.x, max(viewWater.x - lower.y, 0.0), across, viewWater.y);
    vec2 at = upper.xz + (across > 0.0 ? away * (x / across) : vec2(0.0));
    return vec3(at.x, viewWater.x, at.y);
}

// The last point before `point` on the way there from the camera: itself, the place where the ray crosses the surface,
// or the camera's mirror image.
vec3 seenFrom(vec3 point, int way) {
    if (way == straight) return cameraPosition.xyz;
    return way == mirrored ? mirror(cameraPosition.xyz) : viewCrossing(point);
}

// Clip coordinates of a point seen one way; depth runs from 1 near by to 0 far away. It is by perspective; through the
// surface, by metres beyond it.
vec4 viewClip(vec3 point, int way) {
    if (way == straight) return viewProjection * vec4(point, 1.0);
    // A triangle through the surface must not kink there: what is this side of it is seen straight.
    bool beyond = (point.y < viewWater.x) == cameraAbove();
    vec3 seenAt = way == mirrored ? mirror(point) : beyond ? viewCrossing(point) : point;
    vec4 clip = viewProjection * vec4(seenAt, 1.0);
    clip.xy *= viewWater.z;
    if (way == refracted) clip.z = (0.95 - 0.9 * distance(point, seenAt) / waterExtinction.w) * clip.w;
    return clip;
}
