// From counts to where each volume's pieces start: one group, in which each thread has a run of volumes.
#include "interface/bindings.glsl"
#include "interface/volume_starts.glsl"
layout(local_size_x = 256) in;
layout(location = volumesLocation) uniform int volumes;
shared uint sums[256];

void main() {
    int thread = int(gl_LocalInvocationIndex), run = (volumes + 255) / 256;
    int first = min(thread * run, volumes), last = min(first + run, volumes);
    uint sum = 0u;
    for (int i = first; i < last; ++i)
        sum += starts[i];
    sums[thread] = sum;
    barrier();
    uint start = 0u;
    for (int i = 0; i < thread; ++i)
        start += sums[i];
    if (thread == 255) drawn = uvec4(start + sum, 1u, 0u, 0u);
    for (int i = first; i < last; ++i) {
        uint count = starts[i];
        starts[i] = start;
        start += count;
    }
}
