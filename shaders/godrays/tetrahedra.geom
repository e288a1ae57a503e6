// The three tetrahedra of a sub-volume (Iwasaki, Dobashi and Nishita 2002, 3.2), each as the triangles that its outline and
// the point where it is thickest make on the screen. Of one next to the camera, a rectangle around it.
#include "godrays/godray_frame.glsl"
#include "optics/tetrahedron.glsl"
layout(points) in;
layout(triangle_strip, max_vertices = 24) out;
in Piece {
    vec4 corners[6];
    vec2 density;
    flat vec4 light;
} piece[];
// Where the view ray enters and leaves: 1 over metres along the view; over the same: flux by area, metres of water that
// light has passed. Of a rectangle, four numbers are 1 / w at the faces' planes and two the slopes of that light.
noperspective out vec3 entering, leaving;
flat out vec4 light; // as above
flat out vec3 close; // of a rectangle: 1 + which of the faces are entered by, in bits; the light that slopes start from

Corner cornerOf(int k) {
    vec4 corner = piece[0].corners[k];
    return Corner(corner.xyz, vec2(k < 3 ? piece[0].density.x : piece[0].density.y, corner.w));
}

void emit(vec2 place) {
    light = piece[0].light;
    gl_Position = vec4(place, 0.5, 1.0);
    EmitVertex();
}

void emitCorner(Fan fan, int i) {
    entering = fan.entering[i];
    leaving = i == 0 ? fan.leaving : fan.entering[i];
    close = vec3(0.0);
    emit(fan.places[i]);
}

// Whether there is no middle of a pixel between two corners of a rectangle, nor next to it, where corners snap to.
bool isBetweenPixels(vec2 low, vec2 high) {
    const float snap = 1.0 / 128.0;
    vec2 first = ceil(0.5 * (low + 1.0) * target.xy - 0.5 - snap), last = floor(0.5 * (high + 1.0) * target.xy - 0.5 + snap);
    return any(greaterThan(first, last));
}

void draw(Fan fan) {
    if (fan.sides == 0) return;
    vec2 low = min(fan.places[1], min(fan.places[2], fan.places[3]));
    vec2 high = max(fan.places[1], max(fan.places[2], fan.places[3]));
    if (fan.sides == 4) low = min(low, fan.places[4]), high = max(high, fan.places[4]);
    if (isBetweenPixels(low, high)) return;
    emitCorner(fan, 1), emitCorner(fan, 2), emitCorner(fan, 0), emitCorner(fan, 3);
    if (fan.sides == 4) emitCorner(fan, 4);
    EndPrimitive();
    emitCorner(fan, 0), emitCorner(fan, fan.sides), emitCorner(fan, 1);
    EndPrimitive();
}

void draw(Faces faces) {
    if (any(greaterThanEqual(faces.low, faces.high))) return;
    float bits = 1.0;
    for (int k = 0; k < 4; ++k)
        bits += faces.before[k] != 0 ? float(1 << k) : 0.0;
    for (int i = 0; i < 4; ++i) {
        vec2 place = mix(faces.low, faces.high, vec2(i & 1, i >> 1));
        vec3 way = vec3(place, 1.0);
        entering = vec3(dot(faces.planes[0], way), dot(faces.planes[1], way), dot(faces.planes[2], way));
        leaving = vec3(dot(faces.planes[3], way), dot(faces.slopes[0], way), dot(faces.slopes[1], way));
        close = vec3(bits, faces.light);
        emit(place);
    }
    EndPrimitive();
}

void main() {
    if (piece[0].density.x <= 0.0) return;
    for (int i = 0; i < 3; ++i) {
        Tetrahedron t = ofPrism(cornerOf(0), cornerOf(1), cornerOf(2), cornerOf(3), cornerOf(4), cornerOf(5), i);
        if (isClose(t)) draw(facesOf(t, cameraPosition.w));
        else draw(fanOf(t));
    }
}
