// A sub-volume of an illumination volume (Iwasaki, Dobashi and Nishita 2002, 3.2): what lies between three rays and two
// level planes. Volumes are cut as well where they are turned inside out, so that none intersects itself, and where the
// first of their rays ends.
// In: rays and flux (illumination_volumes.comp), where pieces start (volume_starts.comp). Out, a point each: its six
// corners and the light there.
#include "godrays/illumination_volume.glsl"
#include "interface/volume_starts.glsl"
out Piece {
    vec4 corners[6]; // three above, three below: clip x, y, w; metres of water that the light there has passed
    vec2 density;    // flux by area across the light, above and below; 0: nothing is there
    flat vec4 light; // mean direction as the camera has it: right, up, ahead; 1: what it meets is to be asked for
} piece;

// Least cross-section to the mean one. At a focus there is none, and a cone that ends in a point has three times the mean
// at its base.
const float leastSection = 1.0 / 3.0;

// The volume that a piece is of.
int volumeOf(uint number) {
    int low = 0, high = 2 * across.x * across.y - 1;
    while (low < high) {
        int middle = (low + high + 1) / 2;
        if (starts[middle] <= number) low = middle;
        else high = middle - 1;
    }
    return low;
}

// Depth of cut `i`: of `count` by loss, of which the last is the volume's end, and those beside.
float cutAt(Volume volume, vec3 beside, int count, int i) {
    float metres = volume.end - volume.begin;
    int before = 0;
    for (int k = 0; k < 3; ++k) {
        int place = int(ceil(cutShare(beside[k] - volume.begin, metres, lost.x) * float(count))) + k;
        if (place == i) return beside[k];
        before += place < i ? 1 : 0;
    }
    return volume.begin + cutDepth(float(i - before) / float(count), metres, lost.x);
}

void place(Volume volume, float from, float to, float flux) {
    vec3 top[3], bottom[3], mean = vec3(0.0);
    float metres = 0.0;
    for (int k = 0; k < 3; ++k) {
        Ray ray = volume.ray[k];
        float begin = metresAt(ray, from), end = metresAt(ray, to);
        top[k] = ray.from + begin * ray.direction;
        bottom[k] = ray.from + end * ray.direction;
        metres += (end - begin) / 3.0;
        mean += ray.direction;
        piece.corners[k] = vec4((viewProjection * vec4(top[k], 1.0)).xyw, begin);
        piece.corners[3 + k] = vec4((viewProjection * vec4(bottom[k], 1.0)).xyw, end);
    }
    vec3 low = bottom[2] - top[0];
    vec3 volumes = abs(vec3(dot(top[1] - top[0], cross(top[2] - top[0], low)),
                            dot(top[1] - top[0], cross(bottom[1] - top[0], low)),
                            dot(bottom[0] - top[0], cross(bottom[1] - top[0], low)))) / 6.0;
    float whole = volumes.x + volumes.y + volumes.z;
    if (!(whole > 0.0)) return;
    // Light is as dense as its cross-section is small (eq. 4), and what the three tetrahedra hold of it, linear in each,
    // is brought to what passes through them.
    vec3 section = sectionOf(volume);
    float least = leastSection * whole / (to - from);
    float above = 1.0 / max(0.5 * abs(dot(section, vec3(1.0, from, from * from))), least);
    float below = 1.0 / max(0.5 * abs(dot(section, vec3(1.0, to, to * to))), least);
    float held = dot(volumes, vec3(3.0 * above + below, 2.0 * (above + below), above + 3.0 * below)) / 4.0;
    piece.density = flux * metres / held * vec2(above, below);
    vec3 clip = (viewProjection * vec4(normalize(mean), 0.0)).xyw;
    piece.light.xyz = vec3(0.5 * target.xy * clip.xy / target.zw, clip.z);
}

void main() {
    gl_Position = vec4(0.0);
    piece.density = vec2(0.0);
    piece.light = vec4(0.0);
    int number = volumeOf(uint(gl_VertexID)), i = gl_VertexID - int(starts[number]);
    Volume volume = volumeAt(number);
    vec3 beside = besideOf(volume);
    int count = cutsOf(volume);
    float from = cutAt(volume, beside, count, i), to = cutAt(volume, beside, count, i + 1);
    if (!(to > from) || isOutOfView(volume, from, to)) return;
    place(volume, from, to, volumeFlux[number]);
    piece.light.w = from >= splitOf(volume) ? 1.0 : 0.0;
}
