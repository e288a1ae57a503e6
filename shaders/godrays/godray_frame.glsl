// The camera that light in the water is drawn for.
#include "interface/godray_frame.glsl"

vec2 pixelOf(vec4 clip) { return 0.5 * (clip.xy / clip.w + 1.0) * target.xy; }
