// Where illumination volumes are cut along their length, so that what is left of the light is nearly a straight line in
// each piece (Iwasaki, Dobashi and Nishita 2002, 3.2). In the language that GLSL and C++ share.
// Cut into pieces of depth d, light e^(-c t) is too bright by c² d² / 12 of itself where it is taken as straight. The whole
// of that is least where d grows as e^(c t / 3).

// Of the whole, where light has lost but little: thinner, as its pieces, are deeper ones of no more use.
float lostShare(float metres, float perMetre) { return 1.0f - exp(-perMetre * metres / 3.0f); }

// Metres down to the end of `share` of the pieces, [0, 1], of a volume `metres` deep; `perMetre`: the extinction that
// pieces grow with, 1/m.
float cutDepth(float share, float metres, float perMetre) {
    if (perMetre * metres < 0.03f) return share * metres;
    return -3.0f / perMetre * log(max(1.0f - lostShare(metres, perMetre) * share, float(1e-30f)));
}

// The share of the pieces above a depth.
float cutShare(float depth, float metres, float perMetre) {
    if (perMetre * metres < 0.03f) return depth / metres;
    return lostShare(depth, perMetre) / lostShare(metres, perMetre);
}

// Pieces for which that excess is `most` of the light that is scattered. `thick`: the extinction that counts, >= perMetre.
int cutsFor(float metres, float perMetre, float thick, float most) {
    float rate = max(perMetre, float(1e-3f) / metres), rest = thick - 2.0f * rate / 3.0f;
    if (thick * metres < 1e-3f || rest <= 0.0f) return 1;
    float within = (1.0f - exp(-rest * metres)) / rest * thick / (1.0f - exp(-thick * metres));
    return int(ceil(thick * lostShare(metres, rate) / rate * sqrt(0.75f * within / most)));
}
