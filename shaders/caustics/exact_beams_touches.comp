// Exact beams, the touches of quads that may be shaded: one invocation for a quad's beams on one texel.
// In: touches (exact_beams_gather.comp), footprints, flux, tangent planes. Out: flux sums, one channel or three (COLOURED);
// see beam_touch.glsl for EXTINCTION and SHADED.
#include "caustics/beam_touch.glsl"
#include "caustics/beam_touches.glsl"
layout(local_size_x = 64) in;

void main() {
    int count = touchCount.x, step = int(gl_NumWorkGroups.x * gl_WorkGroupSize.x);
    for (int i = int(gl_GlobalInvocationID.x); i < count; i += step) {
        Quad quad;
        if (!loadQuad(touches[i].x, quad)) continue;
        touch(quad, touches[i].x, ivec2(touches[i].y % boxSize.x, touches[i].y / boxSize.x));
    }
}
