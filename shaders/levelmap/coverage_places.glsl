// The places that texels of a level map are covered by: a square grid with as many to a texel's side as asked for, which
// leans against them, so that an edge along the texels or across meets other parts of it in each. After levelmap/box.glsl.
const float lean = 0.0773; // an eighth of the golden ratio, far from any simple fraction

// From texels of the map to texels along the grid, none below 0, and back.
vec2 leant(vec2 texels) { return texels + lean * vec2(texels.y, float(boxSize.x) - texels.x); }
vec2 upright(vec2 places) {
    places.y -= lean * float(boxSize.x);
    return (places + lean * vec2(-places.y, places.x)) / (1.0 + lean * lean);
}
