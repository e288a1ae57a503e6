// A line of light as a strip of two triangles, as wide as it is seen; the part behind the camera is cut off.
#include "interface/bindings.glsl"
#include "godrays/line_width.glsl"
layout(std430, binding = photonLinesBuffer) readonly buffer Lines { vec4 lines[]; };
flat out vec4 clipFrom, clipTo; // ends of what is left
flat out vec4 lineFrom, lineTo; // as in photon_lines.comp
flat out vec2 range;            // which part of the line is left, [0, 1]

void main() {
    lineFrom = lines[2 * gl_InstanceID];
    lineTo = lines[2 * gl_InstanceID + 1];
    vec4 a = viewProjection * vec4(lineFrom.xyz, 1.0), b = viewProjection * vec4(lineTo.xyz, 1.0);
    float near = cameraPosition.w;
    range = vec2(0.0, 1.0);
    if (a.w < near) range.x = (near - a.w) / (b.w - a.w);
    if (b.w < near) range.y = (near - a.w) / (b.w - a.w);
    clipFrom = mix(a, b, range.x);
    clipTo = mix(a, b, range.y);
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0); // out of sight
    if (lineFrom.w <= 0.0 || max(a.w, b.w) <= near) return;
    vec2 from = pixelOf(clipFrom), to = pixelOf(clipTo);
    float size = length(to - from);
    vec2 along = size > 1e-6 ? (to - from) / size : vec2(1.0, 0.0);
    bool atEnd = gl_VertexID >= 2;
    vec4 clip = atEnd ? clipTo : clipFrom;
    // A pixel more, as its edges may touch the line where its centre does not.
    float aside = 0.5 * widthAt(clip.w) + 1.0;
    vec2 pixel = (atEnd ? to : from) + vec2(-along.y, along.x) * ((gl_VertexID & 1) == 0 ? aside : -aside);
    gl_Position = vec4((2.0 * pixel / target.xy - 1.0) * clip.w, clip.z, clip.w);
}
