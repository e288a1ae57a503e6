// Slice images of a receiver: layer i is what lies in the slab of reference plane i (caustics/Volumetric.h).
layout(binding = 0) uniform sampler2DArray slicePosition; // RG32F, as a position map
layout(binding = 1) uniform sampler2DArray sliceDiffuse;  // base colour; alpha: share of the mean light
layout(binding = 2) uniform sampler2DArray sliceNormal;   // RG16, octahedral
