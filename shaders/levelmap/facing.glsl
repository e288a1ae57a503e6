// Which map of a receiver a face belongs to: the main one along the light, or for faces that run along the light a
// further one by where they look (plan/Facings.h).
#include "levelmap/box.glsl"

// 0 the main map; k the side map that looks against facingAxes[k - 1].
int facingOf(vec3 faceNormal) {
    if (abs(dot(faceNormal, facingLight.xyz)) >= facingLight.w) return 0;
    int best = 0;
    for (int k = 1; k < 4; ++k)
        if (dot(faceNormal, facingAxes[k].xyz) > dot(faceNormal, facingAxes[best].xyz)) best = k;
    return facingAxes[best].w > 0.5 ? best + 1 : 0;
}

// Whether this map holds the face; of a sheet, each side has its own.
bool belongsToMap(vec3 faceNormal) {
    int facing = boxSize.w & 7;
    bool sheet = (boxSize.w & 8) != 0;
    int front = facingOf(faceNormal);
    if (!sheet) return front == facing;
    int back = facingOf(-faceNormal);
    return front == facing || back == facing;
}
