// How much of each texel of a level map its receiver covers.
// In: R8, as many places a texel's side as `places` says, 1 where the receiver is. Out, R32F: their mean.
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D covered;
layout(r32f, binding = 0) uniform writeonly image2D coverage;
layout(location = 0) uniform int places;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, imageSize(coverage)))) return;
    float sum = 0.0;
    for (int y = 0; y < places; ++y)
        for (int x = 0; x < places; ++x) sum += texelFetch(covered, texel * places + ivec2(x, y), 0).r;
    imageStore(coverage, texel, vec4(sum / float(places * places)));
}
