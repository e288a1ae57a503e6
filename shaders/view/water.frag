// The surface as the camera sees it: what lies beyond it by refraction, what lies on the camera's side by reflection,
// each with its Fresnel share. Radiance that leaves the water shrinks by n² (L/n² is what stays along a ray).
// In: the refracted and the mirrored view (follow_view.glsl). Out, RGBA32F: radiance, W/(m² sr).
#include "interface/bindings.glsl"
#include "water/surface_shadow.glsl"
#include "view/follow_view.glsl"
layout(binding = refractedRadianceUnit) uniform sampler2D refractedRadiance;
layout(binding = refractedDistanceUnit) uniform sampler2D refractedDistance;
layout(binding = mirroredRadianceUnit) uniform sampler2D mirroredRadiance;
layout(binding = mirroredDistanceUnit) uniform sampler2D mirroredDistance;
layout(location = holeLocation) uniform vec4 hole; // x, z of a corner and extents of what another draw call fills; extent 0: none
layout(location = sunLocation) uniform vec3 sun; // W/m² facing it: adds only this light's glitter; its LightFrame is bound
in vec3 position;
in vec3 normal;
out vec4 outRadiance;

const float pi = 3.14159265358979;
// Mean square slope of the ripples that are too small for the grid: what Cox and Munk (1954) found without wind.
const float rippleSlope = 0.003;
const int steps = 28;

// Radiance that comes up the refracted view ray. The refracted view holds what flat water would show; the ray is
// followed through it until it meets what is stored there.
vec3 radianceBelow(vec3 from, vec3 direction) {
    float farthest = waterExtinction.w;
    float metres = 0.0;
    float leap = farthest / float(steps);
    for (int i = 0; i < steps; ++i) {
        vec3 point = from + metres * direction;
        vec2 uv = viewUv(point, refracted);
        float first = texture(refractedDistance, clamp(uv, 0.0, 1.0)).x;
        float here = distance(point, viewCrossing(point));
        if (first < 0.0) {
            metres += 2.0 * leap;
            continue;
        }
        float gap = first - here;
        if (gap < 1e-3 * farthest) break;
        metres += min(0.9 * gap, 4.0 * leap);
    }
    vec2 uv = clamp(viewUv(from + metres * direction, refracted), 0.0, 1.0);
    vec4 seen = texture(refractedRadiance, uv);
    // Alpha is the share of receivers in the texel.
    vec3 receivers = throughWater(seen.rgb / max(seen.a, 1e-3), metres);
    return mix(deepRadiance.rgb, receivers, seen.a);
}

// Radiance that the surface mirrors: what is on the camera's side of it, and behind that the sky or deep water.
vec3 radianceMirrored(vec3 from, vec3 direction) {
    vec3 beyond = cameraAbove() ? skyRadiance.rgb : deepRadiance.rgb;
    if (nearSideMin.w < 0.5) return beyond;
    // A ray that a steep wave throws at the next one: that sends it up again.
    direction.y = cameraAbove() ? abs(direction.y) : -abs(direction.y);
    Met met = followView(mirroredRadiance, mirroredDistance, mirrored, from, direction, nearSideMin.xyz, nearSideMax.xyz);
    vec3 receivers = cameraAbove() ? met.radiance.rgb : throughWater(met.radiance.rgb, met.metres);
    return mix(beyond, receivers, met.radiance.a);
}

// Radiance that comes down the refracted view ray of a camera under water.
vec3 radianceAbove(vec3 from, vec3 direction) {
    if (farSideMin.w < 0.5) return skyRadiance.rgb;
    Met met = followView(refractedRadiance, refractedDistance, refracted, from, direction, farSideMin.xyz, farSideMax.xyz);
    return mix(skyRadiance.rgb, met.radiance.rgb, met.radiance.a);
}

// A sun's glitter: light mirrored by ripples whose slopes are spread evenly about the wave's own (Cox and Munk 1954;
// the reflected radiance is E F p / (4 cosView cos⁴ of the ripple's tilt)).
vec3 glitter(vec3 view, vec3 up) {
    vec3 light = lightDirection.xyz;
    vec3 halfway = -normalize(view + light);
    float cosTilt = dot(halfway, up);
    if (cosTilt <= 0.05 || dot(light, up) >= 0.0) return vec3(0.0);
    float tan2 = 1.0 / (cosTilt * cosTilt) - 1.0;
    float slopes = exp(-tan2 / rippleSlope) / (pi * rippleSlope);
    float mirrored = 1.0 - fresnelTransmittance(-dot(view, halfway), 1.0 / viewWater.y);
    // Seen flat, ripples hide each other.
    float cosView = max(-dot(view, up), 0.1);
    return sun * surfaceVisibility(position, 0.0) * mirrored * slopes / (4.0 * cosView * pow(cosTilt, 4.0));
}

void main() {
    vec2 inHole = position.xz - hole.xy;
    if (hole.z > 0.0 && all(greaterThan(inHole, vec2(0.0))) && all(lessThan(inHole, hole.zw))) discard;
    vec3 view = normalize(position - cameraPosition.xyz);
    vec3 up = normalize(normal);
    if (sun != vec3(0.0)) {
        outRadiance = vec4(cameraAbove() ? glitter(view, up) : vec3(0.0), 0.0);
        return;
    }
    float ior = viewWater.y;
    if (cameraAbove()) {
        // Seen flatter than its own slope, a wave's far side would be hidden: it reflects at grazing incidence.
        float cosView = max(-dot(view, up), 1e-3);
        float through = fresnelTransmittance(cosView, 1.0 / ior);
        vec3 below = radianceBelow(position, refractDirection(view, up, 1.0 / ior));
        outRadiance = vec4(through * below / (ior * ior) + (1.0 - through) * radianceMirrored(position, reflect(view, up)), 1.0);
    } else {
        // Past the critical angle nothing comes through: Snell's window.
        float through = fresnelTransmittance(dot(view, up), ior);
        vec3 seen = (1.0 - through) * radianceMirrored(position, reflect(view, up));
        if (through > 0.0) seen += through * ior * ior * radianceAbove(position, refractDirection(view, -up, ior));
        outRadiance = vec4(throughWater(seen, distance(position, cameraPosition.xyz)), 1.0);
    }
}
