// Caustics in a host's own shader: GLSL 4.20 core or later, to be included after #version. For each limpid::LitMap of the
// receiver that is drawn, add up
//
//     limpidIrradiance(irradiance, position, normals, worldToTexture, point, faceNormal)
//
// with the map's three textures (any filter and wrap: texels are fetched) and its matrix, `point` in m relative to
// LitMap::origin, and `faceNormal`, the geometric normal of the side that is seen, unit or not (cross(dFdx(point), dFdy(point))
// does). The sum is W/m² on the surface; times albedo / π it is the radiance that leaves a matt one. Only the surface that the
// map shows is lit, on the side that its light falls on: what lies before or behind it, and beside the map, gets 0.

const float limpidMostTurned = 0.5; // cosine between the face and a texel's, below which they are two surfaces

// Octahedral, [0, 1]² to unit (Meyer et al. 2010).
vec3 limpidNormal(vec2 encoded) {
    vec2 p = encoded * 2.0 - 1.0;
    vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
    if (n.z < 0.0) n.xy = (1.0 - abs(p.yx)) * vec2(p.x >= 0.0 ? 1.0 : -1.0, p.y >= 0.0 ? 1.0 : -1.0);
    return normalize(n);
}

// W/m², from the four nearest texels that show the same surface. Red, green and blue are linear.
vec3 limpidIrradiance(sampler2D irradiance, sampler2D position, sampler2D normals, mat4 worldToTexture, vec3 point,
                      vec3 faceNormal) {
    // Rows of the matrix: the box's axes, each over the box's length along it.
    vec3 right = vec3(worldToTexture[0].x, worldToTexture[1].x, worldToTexture[2].x);
    vec3 along = vec3(worldToTexture[0].z, worldToTexture[1].z, worldToTexture[2].z);
    ivec2 size = textureSize(position, 0);
    float texel = 1.0 / (length(right) * float(size.x)); // m
    vec3 light = normalize(along);
    vec3 normal = normalize(faceNormal);
    float facing = -dot(normal, light);
    if (facing <= 0.0) return vec3(0.0);
    vec3 place = (worldToTexture * vec4(point, 1.0)).xyz;
    float depth = place.z / length(along); // m
    vec2 at = place.xy * vec2(size) - 0.5;
    if (any(lessThan(at, vec2(-1.5))) || any(greaterThan(at, vec2(size) + 0.5))) return vec3(0.0);
    // A steep face spans more depth a texel; the bound keeps light from creeping around edges.
    float steep = max(facing, 0.25);
    float slack = texel * (2.0 + 2.0 * sqrt(1.0 - steep * steep) / steep);
    vec2 base = floor(at), part = at - base;
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 from = clamp(ivec2(base) + ivec2(i & 1, i >> 1), ivec2(0), size - 1);
        vec2 seen = texelFetch(position, from, 0).xy;
        if (seen.y == -1.0 || abs(seen.x - depth) > slack) continue;
        if (dot(limpidNormal(texelFetch(normals, from, 0).xy), normal) < limpidMostTurned) continue;
        float weight = ((i & 1) == 0 ? 1.0 - part.x : part.x) * (i < 2 ? 1.0 - part.y : part.y);
        sum += weight * texelFetch(irradiance, from, 0).rgb;
        weights += weight;
    }
    return weights > 0.0 ? sum / weights : vec3(0.0);
}
