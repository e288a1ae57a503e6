// Slice images of a receiver: layer i is what lies in the slab of reference plane i (caustics/Volumetric.h).
#include "interface/bindings.glsl"
layout(binding = positionMapUnit) uniform sampler2DArray slicePosition; // RG32F, as a position map
layout(binding = diffuseMapUnit) uniform sampler2DArray sliceDiffuse;   // base colour; alpha: share of the mean light
layout(binding = normalMapUnit) uniform sampler2DArray sliceNormal;     // RG16, octahedral
