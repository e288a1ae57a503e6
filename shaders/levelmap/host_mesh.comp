// A host's triangles (scene/HostMesh.h) as the vertices and indices of levelmap/ReceiverGeometry.h, in the world.
#include "interface/bindings.glsl"
#include "interface/vertex.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = hostVerticesBuffer) readonly buffer HostVertices { float hostVertices[]; };
layout(std430, binding = hostIndicesBuffer) readonly buffer HostIndices { uint hostIndices[]; };
layout(std430, binding = verticesBuffer) writeonly buffer Vertices { uint vertices[]; };
layout(std430, binding = indicesBuffer) writeonly buffer Indices { uint indices[]; };
layout(location = toWorldLocation) uniform mat4 toWorld; // to m from the scene's origin
layout(location = normalToWorldLocation) uniform mat4 normalToWorld;
layout(location = vertexLayoutLocation) uniform ivec2 vertexLayout; // in words: where the first vertex is; from one to the next
layout(location = offsetsLocation) uniform ivec2 offsets; // in words, of position and normal in a vertex; -1: no normal
layout(location = countsLocation) uniform ivec2 counts; // of vertices; of triangles' corners
layout(location = indexLayoutLocation) uniform ivec2 indexLayout; // where the first index is, in words; bytes of one, 0: there are none


vec3 vectorAt(int word) { return vec3(hostVertices[word], hostVertices[word + 1], hostVertices[word + 2]); }

void writeVector(int word, vec3 v) {
    for (int i = 0; i < 3; ++i) vertices[word + i] = floatBitsToUint(v[i]);
}

void writeVertex(int index) {
    int from = vertexLayout.x + index * vertexLayout.y, to = index * vertexWords;
    writeVector(to, (toWorld * vec4(vectorAt(from + offsets.x), 1.0)).xyz);
    vec3 normal = offsets.y < 0 ? vec3(0.0) : mat3(normalToWorld) * vectorAt(from + offsets.y);
    float size = length(normal);
    writeVector(to + 3, size > 0.0 ? normal / size : vec3(0.0)); // none: shaders take the face's
    for (int i = 6; i < 10; ++i) vertices[to + i] = 0u;  // no textures
    for (int i = 10; i < 12; ++i) vertices[to + i] = ~0u; // white
}

uint indexAt(int corner) {
    if (indexLayout.y == 0) return uint(corner);
    if (indexLayout.y == 4) return hostIndices[indexLayout.x + corner];
    return (hostIndices[indexLayout.x + corner / 2] >> (corner % 2 == 0 ? 0 : 16)) & 0xFFFFu;
}

void main() {
    int index = int(gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x + gl_GlobalInvocationID.x);
    if (index < counts.x) writeVertex(index);
    if (index < counts.y) indices[index] = min(indexAt(index), uint(counts.x - 1));
}
