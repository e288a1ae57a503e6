// What a line of light sends to the camera by being scattered, Papadopoulos 3.4 in units of radiance: of each metre of
// the line the share that is scattered, by phase function and extinction both ways, over the solid angle of the pixels
// that this metre is drawn into.
// Out, RGBA32F, added: W/(m² sr).
#include "godrays/godray_phase.glsl"
#include "godrays/line_width.glsl"
#include "optics/optics.glsl"
flat in vec4 clipFrom, clipTo, lineFrom, lineTo;
flat in vec2 range;
out vec4 radiance;

void main() {
    vec2 from = pixelOf(clipFrom), to = pixelOf(clipTo);
    vec2 way = to - from;
    float size2 = max(dot(way, way), 1e-12);
    vec2 pixel = gl_FragCoord.xy - from;
    // How far down the line this is: evenly on the screen is not evenly in the world.
    float onScreen = clamp(dot(pixel, way) / size2, 0.0, 1.0);
    float here = onScreen * clipFrom.w / max(mix(clipTo.w, clipFrom.w, onScreen), 1e-9);
    float down = mix(range.x, range.y, here);
    vec4 clip = mix(clipFrom, clipTo, here);
    float width = widthAt(clip.w);
    float aside = abs(pixel.x * way.y - pixel.y * way.x) * inversesqrt(size2);
    float cover = clamp(0.5 * width - aside + 0.5, 0.0, 1.0);
    if (width < 1.0) cover = clamp(0.5 * (width + 1.0) - aside, 0.0, width);
    if (cover <= 0.0) discard;

    vec3 point = mix(lineFrom.xyz, lineTo.xyz, down);
    vec3 toPoint = point - cameraPosition.xyz;
    float metres = length(toPoint), travelled = down * lineTo.w;
    vec4 perMetre = (clipTo - clipFrom) / max(lineTo.w * (range.y - range.x), 1e-9);
    vec2 drawn = 0.5 * target.xy * (perMetre.xy * clip.w - clip.xy * perMetre.w) / (clip.w * clip.w); // pixels a metre
    float slant = clip.w / metres;
    float solidAngle = slant * slant * slant / (target.z * target.w);
    vec3 light = (lineTo.xyz - lineFrom.xyz) / max(lineTo.w, 1e-9);
    float cosTurn = -dot(toPoint, light) / metres;
    float share = scatteredTowards(cosTurn) * lineFrom.w * cover / width / (metres * metres * max(length(drawn), 1e-9) * solidAngle);
    radiance = vec4(strength.rgb * scattering.rgb * extinction(extinctionPerMetre.rgb, travelled + metres) * share, 0.0);
}
