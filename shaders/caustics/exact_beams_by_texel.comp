// Exact beams, the pass over the quads on curved faces that nothing shades: every texel that a beam touches takes its part.
// One invocation for the two beams of a narrow quad; BROAD: work groups for those of a broad one. In: footprints, flux,
// tangent planes, depth pyramid, the lists. Out: flux sums, one channel or three (COLOURED). EXTINCTION: water takes light.
#include "interface/bindings.glsl"
#include "caustics/beam_touch.glsl"
#include "caustics/beam_walk.glsl"
#include "caustics/listed_quads.glsl"

void visit(Quad quad, int index, Slab slab, ivec2 texel, float depth) { touch(quad, index, texel); }
void doQuad(Quad quad, int index, int part, int parts) { walk(quad, index, part, parts); }

void main() { doListed(plain); }
