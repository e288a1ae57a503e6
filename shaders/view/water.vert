// The water surface: the moving grid, or the flat rest of it out to the horizon.
#include "include/view.glsl"
layout(location = 0) in vec4 inPosition; // m from the scene's origin
layout(location = 1) in vec4 inNormal;
layout(location = 1) uniform vec4 patchRect; // x, z of a corner and extents of the moving grid; extent 0: the flat rest
out vec3 position;
out vec3 normal;

void main() {
    position = inPosition.xyz;
    normal = inNormal.xyz;
    if (patchRect.z > 0.0) {
        // Outside of the grid the water is flat; waves die away over its rim, so that the two meet without a step.
        vec2 inside = (position.xz - patchRect.xy) / patchRect.zw;
        vec2 rim = smoothstep(vec2(0.0), vec2(0.06), min(inside, 1.0 - inside));
        float share = rim.x * rim.y;
        position.y = mix(viewWater.x, position.y, share);
        normal = mix(vec3(0.0, 1.0, 0.0), normal, share);
    }
    gl_Position = viewProjection * vec4(position, 1.0);
}
