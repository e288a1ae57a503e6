// The faces of one sub-volume as seen along the light, back faces before front faces (Iwasaki et al. 2002, 4.3.1, steps
// 2 and 3). A ray of that view must enter and leave what is tested once, so a sub-volume is drawn as the three
// tetrahedra of the paper's shafts (3.2), and is cut where its beam turns inside out, which would lose a focus.
#include "interface/bindings.glsl"
#include "caustics/sub_volumes.glsl"
layout(points) in;
layout(triangle_strip, max_vertices = 108) out; // 3 parts, 3 tetrahedra, 4 faces
layout(std430, binding = indicesBuffer) readonly buffer Indices { uint indices[]; };
layout(std430, binding = footprintsBuffer) readonly buffer Footprints { vec4 footprints[]; };
layout(std430, binding = originDepthsBuffer) readonly buffer OriginDepths { float originDepths[]; };
layout(std430, binding = rangesBuffer) readonly buffer Ranges { ivec2 ranges[]; };
in VolumeData {
    flat int beam;
    flat int number;
} volume[];
out vec2 slope;       // sideways per metre of depth
out float startDepth; // of the beam, m
flat out int beam;

// A corner of a tetrahedron and the ray that it lies on.
struct Corner {
    vec3 at;  // texels from the receiver's middle, on the grid that rasterisers snap to; depth, m
    vec3 ray; // slope, start
};

Corner cornerAt(vec4 footprint, float start, float depth) {
    vec2 texel = footprint.xy + depth * footprint.zw - 0.5 * vec2(boxSize.xy);
    return Corner(vec3(floor(clamp(texel, -4e6, 4e6) * 256.0 + 0.5) / 256.0, depth), vec3(footprint.zw * boxExtent.w, start));
}

void emit(Corner corner) {
    slope = corner.ray.xy;
    startDepth = corner.ray.z;
    beam = volume[0].beam;
    gl_Position = vec4(2.0 * corner.at.xy / vec2(boxSize.xy), clipDepth(corner.at.z), 1.0);
    EmitVertex();
}

// A face is a front one where the fourth corner lies behind it: `inner`, the tetrahedron's volume signed by the face's
// corners and that one, and the area as it is seen have the same sign.
void drawFace(Corner a, Corner b, Corner c, float inner, bool front) {
    float area = cross2(b.at.xy - a.at.xy, c.at.xy - a.at.xy);
    if (area == 0.0 || (area * inner > 0.0) != front) return;
    bool turned = area > 0.0 != front;
    emit(a);
    if (turned) emit(c), emit(b);
    else emit(b), emit(c);
    EndPrimitive();
}

void drawTetrahedron(Corner a, Corner b, Corner c, Corner d) {
    float inner = dot(cross(b.at - a.at, c.at - a.at), d.at - a.at);
    if (inner == 0.0) return;
    inner = sign(inner);
    for (int i = 0; i < 2; ++i) {
        bool front = i == 1;
        drawFace(a, b, c, inner, front);
        drawFace(a, b, d, -inner, front);
        drawFace(a, c, d, inner, front);
        drawFace(b, c, d, -inner, front);
    }
}

void main() {
    ivec2 range = ranges[volume[0].beam];
    if (volume[0].number >= range.y) return;
    int number = range.x + volume[0].number;
    // In the order of the water's vertices: the diagonals of a side are then those of the volume beyond it.
    ivec3 v = ivec3(indices[3 * volume[0].beam], indices[3 * volume[0].beam + 1], indices[3 * volume[0].beam + 2]);
    if (v.x > v.y) v = v.yxz;
    if (v.y > v.z) v = v.xzy;
    if (v.x > v.y) v = v.yxz;
    vec4 a = footprints[v.x], b = footprints[v.y], c = footprints[v.z];
    vec2 depths = subVolume(number);
    ivec2 found = subVolumesWithin(a, b, c, depths);
    if (number < found.x || number > found.y) return;

    vec3 starts = vec3(originDepths[v.x], originDepths[v.y], originDepths[v.z]);
    vec2 turns = turnsOf(crossSection(a, b, c));
    float top = depths.x;
    for (int i = 0; i < 3; ++i) {
        float bottom = i < 2 ? clamp(turns[i], top, depths.y) : depths.y;
        if (bottom == top) continue;
        Corner p = cornerAt(a, starts.x, top), q = cornerAt(b, starts.y, top), r = cornerAt(c, starts.z, top);
        Corner s = cornerAt(a, starts.x, bottom), t = cornerAt(b, starts.y, bottom), u = cornerAt(c, starts.z, bottom);
        drawTetrahedron(p, q, r, u);
        drawTetrahedron(p, q, t, u);
        drawTetrahedron(p, s, t, u);
        top = bottom;
    }
}
