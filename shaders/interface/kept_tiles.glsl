// The tiles of the water's grid that may send a beam to a map: filled by cull_tiles.comp.
layout(std430, binding = 2) buffer Kept {
    uint keptGroups[3]; // to dispatch: rows of 65,535 and how many rows
    uint keptTiles;
    uint keptBeams;
    uint kept[];
};
