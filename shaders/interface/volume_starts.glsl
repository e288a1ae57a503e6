// The pieces of all illumination volumes, one volume after another.
#pragma once
#include "interface/blocks.glsl"
STORAGE_BLOCK(VolumeStarts, volumeStartsBuffer) {
    uvec4 drawn;   // pieces, instances, first, base: as the command to draw them wants it
    ENDLESS(uint, starts) // the number of each volume's first piece
};
