// What a tetrahedron of lit water sends to the camera: the mean of what is scattered where the view ray enters and where it
// leaves, over the way between (Iwasaki, Dobashi and Nishita 2002, eq. 5), with eq. 4 and 6 at both in every pixel. What
// ends the view ends it here too.
// In: depth of the view; the scene depth map of the light. Out, RGBA32F, added: W/(m² sr).
#include "interface/bindings.glsl"
#include "godrays/godray_phase.glsl"
#include "levelmap/scene_depth.glsl"
#include "optics/tetrahedron.glsl"
layout(binding = viewDepthUnit) uniform sampler2D viewDepth; // 1 at the near plane, 0 far away
layout(location = nearLocation) uniform float near;                // m
noperspective in vec3 entering, leaving;
flat in vec4 light;
flat in vec3 close;
out vec4 radiance;

// Of the way between two places on the view ray through the pixel, that light may reach, by the mean light.
float litShare(vec2 aside, float from, float to) {
    vec3 row0 = vec3(viewProjection[0].x, viewProjection[1].x, viewProjection[2].x);
    vec3 row1 = vec3(viewProjection[0].y, viewProjection[1].y, viewProjection[2].y);
    vec3 ahead = vec3(viewProjection[0].w, viewProjection[1].w, viewProjection[2].w);
    vec3 way = ahead + normalize(row0) * aside.x + normalize(row1) * aside.y;
    float lit = 0.0;
    for (int i = 0; i < 4; ++i)
        if (beforeFirst(cameraPosition.xyz + mix(from, to, (float(i) + 0.5) / 4.0) * way).x > 0.0) lit += 0.25;
    return lit;
}

void main() {
    float end = texelFetch(viewDepth, ivec2(gl_FragCoord.xy), 0).x / near;
    vec2 seen = vec2(entering.x, leaving.x), atFrom, atTo; // 1 / w; flux by area, metres
    if (close.x > 0.0) {
        int bits = int(close.x) - 1;
        bvec4 before = bvec4((bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0);
        seen = throughFaces(vec4(entering, leaving.x), before, cameraPosition.w);
    }
    seen.y = max(seen.y, end);
    if (seen.x <= seen.y || seen.y <= 0.0) discard;
    if (close.x > 0.0) {
        atFrom = close.yz + leaving.yz / seen.x;
        atTo = close.yz + leaving.yz / seen.y;
    } else {
        atFrom = entering.yz / seen.x;
        atTo = mix(atFrom, leaving.yz / leaving.x,
                   (seen.x - seen.y) / seen.y * leaving.x / (entering.x - leaving.x));
    }
    float from = 1.0 / seen.x, to = 1.0 / seen.y, thick = (seen.x - seen.y) * from * to;
    vec2 aside = (gl_FragCoord.xy - 0.5 * target.xy) / target.zw; // of the way ahead
    float slant = sqrt(1.0 + dot(aside, aside));
    float share = scatteredTowards(-dot(vec3(aside, 1.0), light.xyz) / slant) * thick * slant;
    if (light.w > 0.5) share *= litShare(aside, from, to);
    radiance = vec4(0.5 * share * strength.rgb * scattering.rgb *
                        (atFrom.x * extinction(extinctionPerMetre.rgb, atFrom.y + from * slant) +
                         atTo.x * extinction(extinctionPerMetre.rgb, atTo.y + to * slant)),
                    0.0);
}
