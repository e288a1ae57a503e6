// What a point light under water sees first: six square views along the axes, in two rows of three.
// R32F: metres from the point light; 1e30 where there is nothing.
#include "water/light.glsl"

// The three axes of view `face`: the one it looks along (against it for odd faces), and those to its right and up.
ivec3 pointLightAxes(int face) { return (face / 2 + ivec3(0, 1, 2)) % 3; }

int pointLightFace(vec3 direction) {
    vec3 size = abs(direction);
    int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return 2 * axis + (direction[axis] < 0.0 ? 1 : 0);
}

// Direction through a place of a view, [-1, 1]².
vec3 pointLightDirection(int face, vec2 at) {
    ivec3 axes = pointLightAxes(face);
    vec3 direction;
    direction[axes.x] = face % 2 == 0 ? 1.0 : -1.0;
    direction[axes.y] = at.x;
    direction[axes.z] = at.y;
    return normalize(direction);
}

// The share of the point light's light that reaches `point`, [0, 1]: the four nearest texels, each asked whether something
// lies before the point's tangent plane along its own ray.
float pointLightVisibility(sampler2D map, vec3 point, vec3 normal) {
    vec3 way = point - lightPosition.xyz;
    int face = pointLightFace(way), side = textureSize(map, 0).x / 3;
    ivec3 axes = pointLightAxes(face);
    vec2 at = (0.5 + 0.5 * vec2(way[axes.y], way[axes.z]) / abs(way[axes.x])) * float(side) - 0.5;
    vec2 base = floor(at), part = at - base;
    float slack = 2.0 * length(way) * 2.0 / float(side);
    float lit = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 texel = clamp(ivec2(base) + ivec2(i & 1, i >> 1), ivec2(0), ivec2(side - 1));
        vec3 direction = pointLightDirection(face, 2.0 * (vec2(texel) + 0.5) / float(side) - 1.0);
        float along = dot(normal, direction);
        float here = abs(along) < 0.05 ? dot(way, direction) : dot(normal, way) / along;
        float first = texelFetch(map, texel + side * ivec2(face % 3, face / 3), 0).x;
        if (first >= here - slack) lit += ((i & 1) == 0 ? 1.0 - part.x : part.x) * (i < 2 ? 1.0 - part.y : part.y);
    }
    return lit;
}
