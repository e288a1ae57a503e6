// Passes a triangle of a receiver on with its own plane: flux goes by the geometric normal, and normals from
// derivatives would be noisy. Degenerate triangles end here. For geometry shaders.
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;
in VertexData {
    vec3 position; // m from the scene's origin
    vec3 normal;   // shading
    vec4 uv;
    vec4 color;
} vertexIn[];
out FragmentData {
    vec3 position;
    vec3 normal;
    vec4 uv;
    vec4 color;
    flat vec3 faceNormal; // unit, by the winding
    flat vec3 facePoint;  // a corner: a point of the face's plane
} vertexOut;

void passFace() {
    vec3 a = vertexIn[0].position, b = vertexIn[1].position, c = vertexIn[2].position;
    vec3 area = cross(b - a, c - a);
    float size = length(area);
    if (!(size > 0.0)) return;
    for (int i = 0; i < 3; ++i) {
        gl_Position = gl_in[i].gl_Position;
        vertexOut.position = vertexIn[i].position;
        vertexOut.normal = vertexIn[i].normal;
        vertexOut.uv = vertexIn[i].uv;
        vertexOut.color = vertexIn[i].color;
        vertexOut.faceNormal = area / size;
        vertexOut.facePoint = a;
        EmitVertex();
    }
    EndPrimitive();
}
