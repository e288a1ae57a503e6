// How far the grid of places that covers texels leans against them (levelmap/coverage_places.glsl).
#pragma once
const float coverageLean = 0.0773; // an eighth of the golden ratio, far from any simple fraction
