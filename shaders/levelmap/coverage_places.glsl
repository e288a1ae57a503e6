// The places that texels of a level map are covered by: a square grid with as many to a texel's side as asked for, which
// leans against them, so that an edge along the texels or across meets other parts of it in each. After levelmap/box.glsl.
#include "interface/coverage_lean.glsl"

// From texels of the map to texels along the grid, none below 0, and back.
vec2 leant(vec2 texels) { return texels + coverageLean * vec2(texels.y, float(boxSize.x) - texels.x); }
vec2 upright(vec2 places) {
    places.y -= coverageLean * float(boxSize.x);
    return (places + coverageLean * vec2(-places.y, places.x)) / (1.0 + coverageLean * coverageLean);
}
