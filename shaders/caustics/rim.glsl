// Which places of a texel show the surface at its middle: 4 x 4 places, a bit each, row by row, in the tangent planes' w. Light
// is counted on these alone; what else lies in a texel at a rim, before the surface or above the water, has its own texels.
const int rimPlaces = 4, allPlaces = 0xffff;

int placesShown(vec4 plane) { return int(plane.w); }
bool isRim(vec4 plane) { return placesShown(plane) != allPlaces; }
bool showsPlace(int shown, vec2 within) {
    ivec2 at = clamp(ivec2(within * float(rimPlaces)), ivec2(0), ivec2(rimPlaces - 1));
    return (shown >> (at.y * rimPlaces + at.x) & 1) != 0;
}
