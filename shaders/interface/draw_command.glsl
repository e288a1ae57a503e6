// The command of an indirect draw, as OpenGL has it.
#pragma once
#include "interface/blocks.glsl"
STORAGE_BLOCK(DrawCommand, drawCommandBuffer) {
    uint points;
    uint instances;
    uint firstPoint;
    uint firstInstance;
};
