// One light over flat water: the mean light. Every position is in metres from the scene's origin.
#include "optics/cone.glsl"
#include "optics/optics.glsl"
#include "interface/light_frame.glsl"

bool isPointLight() { return lightPosition.w > 0.5; }

// Direction of the incident light at a point of the surface, unit.
vec3 incidentDirection(vec3 surface) {
    return isPointLight() ? normalize(surface - lightPosition.xyz) : lightDirection.xyz;
}

// The share of a point light's intensity that goes towards a point, [0, 1].
float intensityShare(vec3 point) {
    return isPointLight() ? coneShare(dot(incidentDirection(point), lightDirection.xyz), lightCone.x, lightCone.y) : 1.0;
}

// Where the mean light that reaches `point` crosses the flat surface. Above the water it goes on as it would: a
// triangle through the surface must not kink there, or what is left of it under water is drawn in the wrong place.
vec3 entryPoint(vec3 point) {
    float below = waterSurface.x - point.y;
    if (!isPointLight()) return point - lightRefracted.xyz * (below / -lightRefracted.y);
    vec2 away = point.xz - lightPosition.xz;
    if (below < 0.0) {
        vec2 foot = lightPosition.xz + away * ((lightPosition.y - waterSurface.x) / max(lightPosition.y - point.y, 1e-6));
        return vec3(foot.x, waterSurface.x, foot.y);
    }
    float across = length(away);
    float x = flatCrossing(lightPosition.y - waterSurface.x, below, across, waterSurface.y);
    vec2 at = lightPosition.xz + (across > 0.0 ? away * (x / across) : vec2(0.0));
    return vec3(at.x, waterSurface.x, at.y);
}

// Unit direction of the mean light below the flat surface at `entry`.
vec3 meanDirection(vec3 entry) {
    if (!isPointLight()) return lightRefracted.xyz;
    return refractDirection(normalize(entry - lightPosition.xyz), vec3(0.0, 1.0, 0.0), 1.0 / waterSurface.y);
}

// Place of a surface point in the scene depth map, [0, 1]².
vec2 sceneDepthUv(vec3 entry) { return (entry.xz - sceneDepthRect.xy) / sceneDepthRect.zw; }
vec3 sceneDepthEntry(vec2 uv) {
    vec2 at = sceneDepthRect.xy + uv * sceneDepthRect.zw;
    return vec3(at.x, waterSurface.x, at.y);
}
