// Whether a face goes on from another one within a texel. After levelmap/box.glsl.
const float steepest = 20.0;  // m by m; a face along the axis has no depth at a place
const float mostCrease = 4.0; // m by m between two faces within a texel; beyond, light is not shared

// Depth by metre along u and w of a face.
vec2 depthGradient(vec3 normal) {
    float along = dot(normal, boxT.xyz);
    float divisor = abs(along) > 1.0 / steepest ? along : (along < 0.0 ? -1.0 : 1.0) / steepest;
    return -vec2(dot(normal, boxU.xyz), dot(normal, boxW.xyz)) / divisor;
}

// How far off the one face's plane the other may lie, m.
float creaseSlack(float crease) { return boxExtent.w * (0.5 + crease); }
