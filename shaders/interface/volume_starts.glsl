// The pieces of all illumination volumes, one volume after another.
layout(std430, binding = 8) buffer VolumeStarts {
    uvec4 drawn;   // pieces, instances, first, base: as the command to draw them wants it
    uint starts[]; // the number of each volume's first piece
};
