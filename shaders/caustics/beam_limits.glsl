// Where passes over beams turn to another way.

// Light that makes less than this of -n·t, by the part that does not depend on how steep the face is, runs along it.
const float grazing = 0.02;

// A quad that touches more texels is broad: not for one invocation. Of one that may be shaded, its touches are kept.
const int mostTexels = 256, mostGathered = 32;
