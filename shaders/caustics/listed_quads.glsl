// The quads that a pass left in a list: an invocation takes a narrow one, work groups a broad one (BROAD).
#include "caustics/beam_lists.glsl"

// What the pass does with a quad, or with the part of it that falls to this work group.
void doQuad(Quad quad, int index, int part, int parts);

void doListed(int list) {
#ifdef BROAD
    list += broad;
    int item = int(gl_WorkGroupID.x), step = int(gl_NumWorkGroups.x), part = int(gl_WorkGroupID.y), parts = int(gl_NumWorkGroups.y);
#else
    int item = int(gl_GlobalInvocationID.x), step = int(gl_NumWorkGroups.x * gl_WorkGroupSize.x), part = 0, parts = 1;
#endif
    int count = countIn(list);
    for (; item < count; item += step) {
        int index = listedIn(list, item);
        Quad quad;
        if (loadQuad(index, quad)) doQuad(quad, index, part, parts);
    }
}
