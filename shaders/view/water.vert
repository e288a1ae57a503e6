// The water surface: the moving grid, or the flat rest of it out to the horizon.
#include "interface/bindings.glsl"
#include "view/view.glsl"
layout(location = positionAttribute) in vec4 inPosition; // m from the scene's origin
layout(location = normalAttribute) in vec4 inNormal;
layout(location = flatRestLocation) uniform int flatRest; // 1: two triangles over `horizon`, without attributes
layout(location = horizonLocation) uniform vec4 horizon; // x, z of a corner and of the opposite one, m from the scene's origin
out vec3 position;
out vec3 normal;

void main() {
    position = inPosition.xyz;
    normal = inNormal.xyz;
    if (flatRest != 0) {
        int corner = gl_VertexID < 3 ? gl_VertexID : gl_VertexID == 3 ? 2 : gl_VertexID == 4 ? 1 : 3;
        position = vec3((corner & 1) != 0 ? horizon.z : horizon.x, waterRest.x, (corner & 2) != 0 ? horizon.w : horizon.y);
        normal = vec3(0.0, 1.0, 0.0);
    } else {
        float share = rimShare((position.xz - patchRect.xy) / patchRect.zw);
        position.y = mix(waterRest.x, position.y, share);
        normal = mix(vec3(0.0, 1.0, 0.0), normal, share);
    }
    gl_Position = viewProjection * vec4(position, 1.0);
}
