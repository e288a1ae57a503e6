// How wide a line of light is drawn.
#include "interface/bindings.glsl"
#include "godrays/godray_frame.glsl"
layout(location = lineWidthLocation) uniform vec2 lineWidth; // at least, pixels; of the piece of water that a line stands for, m

// A line is as wide as the light that it stands for, and at least as its setting says. At `w` metres along the view.
float widthAt(float w) { return max(lineWidth.x, lineWidth.y * 0.5 * (target.z + target.w) / w); }
