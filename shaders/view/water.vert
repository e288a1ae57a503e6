// The water surface: the moving grid, or the flat rest of it out to the horizon.
#include "interface/bindings.glsl"
#include "view/view.glsl"
layout(location = positionAttribute) in vec4 inPosition; // m from the scene's origin
layout(location = normalAttribute) in vec4 inNormal;
layout(location = flatRestLocation) uniform int flatRest;
out vec3 position;
out vec3 normal;

void main() {
    position = inPosition.xyz;
    normal = inNormal.xyz;
    if (flatRest == 0) {
        float share = rimShare((position.xz - patchRect.xy) / patchRect.zw);
        position.y = mix(waterRest.x, position.y, share);
        normal = mix(vec3(0.0, 1.0, 0.0), normal, share);
    }
    gl_Position = viewProjection * vec4(position, 1.0);
}
