// The frame of a receiver's maps: thesis 4.2.1 (see core/OrientedBox.h). Positions in m from the scene's origin.
layout(std140, binding = 1) uniform BoxFrame {
    vec4 boxCorner; // near face, texel (0, 0)
    vec4 boxU;      // unit, right
    vec4 boxW;      // unit, down
    vec4 boxT;      // unit, along the light
    vec4 boxExtent; // along u, w, t, m; w: side of a texel, m
    ivec4 boxSize; // texels along u, w; reference planes asked for; this map's facing, + 8 for a mesh that is
                    // not closed, + 16 for one that is and that the water's surface cuts open
    vec4 facingLight;   // mean light, unit; w: faces whose normal is within this sine of being across it are steep
    vec4 boxShear;      // how depth grows along u and w on the whole, m/m: the lean of the receiver in its box
    vec4 boxGradients;  // least along u, w and greatest along u, w of any face's depth, m/m
    vec4 facingAxes[4]; // unit, across the mean light; w: 1 where there is a side map
};

// (along u, along w, depth) of a point, m.
vec3 boxLocal(vec3 point) {
    vec3 q = point - boxCorner.xyz;
    return vec3(dot(q, boxU.xyz), dot(q, boxW.xyz), dot(q, boxT.xyz));
}
vec3 boxPoint(vec3 local) {
    return boxCorner.xyz + local.x * boxU.xyz + local.y * boxW.xyz + local.z * boxT.xyz;
}
// A direction in the box's axes.
vec3 boxDirection(vec3 d) { return vec3(dot(d, boxU.xyz), dot(d, boxW.xyz), dot(d, boxT.xyz)); }
