// The intersection of the beams' edges with one reference plane (thesis 4.4), in texels of the receiver's maps.
#include "interface/bindings.glsl"
#include "levelmap/box.glsl"
layout(location = footprintAttribute) in vec4 footprint;      // texels; texels per metre (footprints.comp)
layout(location = originDepthAttribute) in float originDepth; // m
layout(location = planeDepthLocation) uniform float planeDepth;     // m
invariant gl_Position; // two programs draw with it, and must meet the same texels
out vec2 slope;                            // sideways per metre of depth
out float startDepth;                      // m

void main() {
    precise vec2 texel = footprint.xy + planeDepth * footprint.zw;
    slope = footprint.zw * boxExtent.w;
    startDepth = originDepth;
    gl_Position = vec4(2.0 * texel / vec2(boxSize.xy) - 1.0, 0.0, 1.0);
}
