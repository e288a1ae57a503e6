// A point stands for one sub-volume of a beam: the instance says which.
out VolumeData {
    flat int beam;
    flat int number; // among those that may hold something
} volume;

void main() {
    volume.beam = gl_VertexID;
    volume.number = gl_InstanceID;
    gl_Position = vec4(0.0);
}
