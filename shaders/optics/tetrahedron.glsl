// A tetrahedron as the camera sees it: triangles around the point where it is thickest (Iwasaki, Dobashi and Nishita 2002,
// 3.2). In the language that GLSL and C++ share.
// Of a view ray there are two values: where it enters and where it leaves. Divided by w, what is linear in space is linear
// on the screen over every plane, and over each of the triangles a ray enters by one face and leaves by one: so both values
// are exact in every pixel, where the paper has the thickness alone, and in between as if it were linear.
#include "optics/cross.glsl"

struct Corner {
    vec3 clip;  // x, y, w
    vec2 light; // anything linear in space
};

struct Tetrahedron {
    Corner corners[4];
};

struct Fan {
    int sides;         // triangles, each of the thick point and two neighbours of the outline; 0: nothing is seen
    vec2 places[5];    // on the screen, [-1, 1]²: the thick point, the outline in turn
    vec3 entering[5];  // there, 1 / w and light / w
    vec3 leaving;      // at the thick point; at the outline it is as entering
};

// A tetrahedron by its faces, for one next to the camera: places on the screen are too far apart there for the rounding of
// what is drawn between them.
struct Faces {
    vec3 planes[4];    // times (x, y, 1) of the screen: 1 / w where the view ray passes the face's plane
    int before[4];     // 1 where the ray enters; it leaves by the others (no bool: zink hands on none)
    vec3 slopes[2];    // times the same and w, added to
    vec2 light;        // what light would be at the camera: light
    vec2 low, high;    // what it may cover of the screen
};

Tetrahedron tetrahedronOf(Corner a, Corner b, Corner c, Corner d) {
    Tetrahedron t;
    t.corners[0] = a;
    t.corners[1] = b;
    t.corners[2] = c;
    t.corners[3] = d;
    return t;
}

// Tetrahedron `i`, below 3, of a prism whose corners a, b, c lie over d, e, f. Where corners are in one order throughout,
// neighbours cut the side between them alike.
Tetrahedron ofPrism(Corner a, Corner b, Corner c, Corner d, Corner e, Corner f, int i) {
    if (i == 0) return tetrahedronOf(a, b, c, f);
    return i == 1 ? tetrahedronOf(a, b, e, f) : tetrahedronOf(a, d, e, f);
}

// All corners before the camera. Of the four places there is one combination that is zero, with weights that are: of those
// above zero and of those below it the same point of the screen, where the view ray passes what the ones have between them
// and what the others have. One against three is the paper's case I, two against two its case II.
Fan fanOf(Tetrahedron t) {
    // From the farthest corner: places of those next to the camera are so large that others are lost in their rounding.
    int farthest = 0;
    for (int k = 1; k < 4; ++k)
        farthest = t.corners[k].clip.z > t.corners[farthest].clip.z ? k : farthest;
    vec2 at[4];
    vec3 seen[4];
    for (int k = 0; k < 4; ++k) {
        Corner corner = t.corners[k == 0 ? farthest : k == farthest ? 0 : k];
        float near = 1.0f / corner.clip.z;
        at[k] = vec2(corner.clip.x, corner.clip.y) * near;
        seen[k] = vec3(1.0f, corner.light.x, corner.light.y) * near;
    }
    vec2 b = at[1] - at[0], c = at[2] - at[0], d = at[3] - at[0];
    float weights[4];
    weights[1] = -cross2(c, d);
    weights[2] = cross2(b, d);
    weights[3] = -cross2(b, c);
    weights[0] = -(weights[1] + weights[2] + weights[3]);

    Fan fan;
    fan.sides = 0;
    float over = 0.0f, under = 0.0f;
    for (int k = 0; k < 4; ++k) {
        over += max(weights[k], 0.0f);
        under += max(-weights[k], 0.0f);
    }
    if (!(over > 0.0f && under > 0.0f)) return fan;
    vec2 place = vec2(0.0f);
    vec3 one = vec3(0.0f), other = vec3(0.0f);
    int ones[4], others[4], oneCount = 0, otherCount = 0;
    for (int k = 0; k < 4; ++k) {
        if (weights[k] > 0.0f) {
            place += weights[k] / over * at[k];
            one += weights[k] / over * seen[k];
            ones[oneCount++] = k;
        } else {
            other -= weights[k] / under * seen[k];
            others[otherCount++] = k;
        }
    }
    bool oneFirst = one.x >= other.x;
    fan.places[0] = place;
    fan.entering[0] = oneFirst ? one : other;
    fan.leaving = oneFirst ? other : one;
    fan.sides = oneCount == 2 ? 4 : 3;
    for (int k = 0; k < 4; ++k) {
        int corner = 0; // case II: corners of the two edges take turns; case I: those of the face
        if (oneCount == 2) corner = (k & 1) == 0 ? ones[k / 2] : others[k / 2];
        else corner = oneCount == 3 ? ones[k % 3] : others[k % 3];
        fan.places[1 + k] = at[corner];
        fan.entering[1 + k] = seen[corner];
    }
    return fan;
}

// Whether some corner is so much nearer than another that it is better drawn by its faces.
bool isClose(Tetrahedron t) {
    float least = t.corners[0].clip.z, most = least;
    for (int k = 1; k < 4; ++k) {
        least = min(least, t.corners[k].clip.z);
        most = max(most, t.corners[k].clip.z);
    }
    return least < most / 8.0f;
}

// Faces of what lies before the plane w = near. Of no extent: low > high.
Faces facesOf(Tetrahedron t, float near) {
    Faces faces;
    faces.low = vec2(1.0f);
    faces.high = vec2(-1.0f);
    faces.light = vec2(0.0f);
    faces.slopes[0] = faces.slopes[1] = vec3(0.0f);
    for (int k = 0; k < 4; ++k) {
        Corner own = t.corners[k];
        vec3 a = t.corners[(k + 1) & 3].clip, b = t.corners[(k + 2) & 3].clip, c = t.corners[(k + 3) & 3].clip;
        vec3 normal = cross(b - a, c - a);
        float offset = dot(normal, a), height = dot(normal, own.clip - a);
        if (height == 0.0f) return faces;
        // The share of corner `k` at p is (normal · p - offset) / height.
        faces.light -= offset / height * own.light;
        faces.slopes[0] += own.light.x / height * normal;
        faces.slopes[1] += own.light.y / height * normal;
        faces.before[k] = offset / height > 0.0f ? 1 : 0;
        float least = 1e-9f * dot(abs(normal), abs(a));
        faces.planes[k] = normal / (abs(offset) > least ? offset : offset < 0.0f ? -least : least);
    }
    vec2 low = vec2(1e30f), high = vec2(-1e30f);
    for (int k = 0; k < 4; ++k)
        for (int i = k; i < 4; ++i) {
            vec3 a = t.corners[k].clip, b = t.corners[i].clip;
            if ((a.z < near) == (b.z < near) && (i > k || a.z < near)) continue;
            vec3 p = i == k ? a : a + (a.z - near) / (a.z - b.z) * (b - a);
            vec2 at = vec2(p.x, p.y) / (i == k ? p.z : near);
            low = min(low, at);
            high = max(high, at);
        }
    faces.low = max(low, vec2(-1.0f));
    faces.high = min(high, vec2(1.0f));
    return faces;
}

// 1 / w where a view ray enters and leaves, by what it passes each plane at; the second is larger where it passes by.
vec2 throughFaces(vec4 planes, bvec4 before, float near) {
    vec2 range = vec2(1.0f / near, 0.0f);
    for (int k = 0; k < 4; ++k) {
        if (before[k]) range.x = min(range.x, planes[k]);
        else range.y = max(range.y, planes[k]);
    }
    return range;
}
