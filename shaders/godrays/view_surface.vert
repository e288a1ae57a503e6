// The water's surface as the camera sees it, for its depth alone.
#include "interface/bindings.glsl"
#include "godrays/godray_frame.glsl"
layout(location = positionAttribute) in vec4 inPosition; // m from the scene's origin

void main() { gl_Position = viewProjection * vec4(inPosition.xyz, 1.0); }
