#pragma once

#include "Mesh.h"

namespace limpid::models {

/// Latitude and longitude: `slices` around, `stacks` from pole to pole; 2 · slices · (stacks − 1) triangles.
Mesh sphere(int slices, int stacks);

/// A cube of 12 triangles.
Mesh box();

/// Nine equal cubes joined as a three-dimensional cross: one in the middle, one on each of its faces, and one
/// more at either end along x. The 38 faces that stay free make 76 triangles and a watertight solid.
Mesh cross();

/// Newell's 32 patches, each cut into `steps` × `steps` quads.
Mesh teapot(int steps);

/// A fish seen swimming towards +x, its tail bent to one side in the stroke.
Mesh fish();

/// A dolphin arched in a leap, snout towards +x.
Mesh dolphin();

/// The thesis's other receivers, by its names ("angle fish" is the angelfish of aquaria). Swimmers look
/// towards +x; all have colours of their own.
Mesh angleFish();
Mesh redBetta();
Mesh siameseTiger();
Mesh barramundi();
Mesh brownTrout();
Mesh lionHead();
Mesh steelHead();
Mesh bass();
Mesh shark();
Mesh leopardShark();
Mesh sandBarShark();
Mesh whale();
Mesh manta();
Mesh sunFish();
Mesh horse();
Mesh hammer();
Mesh car();
Mesh chair();
Mesh sink();
Mesh sofa();
Mesh ufo();
Mesh plane();
Mesh helicopter();
Mesh camera();
Mesh tank();

} // namespace limpid::models
