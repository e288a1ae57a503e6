// Refraction and Fresnel's law. Pure functions in the language that GLSL and C++ share (float literals carry
// an f, no out parameters), so that the CPU and its tests run the same lines: see core/Optics.h.

// Direction of the refracted ray, thesis eq. 2-8. `incident` and `normal` unit, `normal` on the side that the
// light comes from, `eta` = index there / index beyond. Zero where there is total internal reflection.
vec3 refractDirection(vec3 incident, vec3 normal, float eta) {
    float cosIncident = -dot(incident, normal);
    float k = 1.0f - eta * eta * (1.0f - cosIncident * cosIncident);
    if (k < 0.0f) return vec3(0.0f);
    return eta * incident + (eta * cosIncident - sqrt(k)) * normal;
}

// Share of unpolarised light that crosses the surface, [0, 1]; 0 for light from behind and for total internal
// reflection. `cosIncident` = -dot(incident, normal), `eta` as above.
float fresnelTransmittance(float cosIncident, float eta) {
    float sinSquared = eta * eta * (1.0f - cosIncident * cosIncident);
    if (cosIncident <= 0.0f || sinSquared >= 1.0f) return 0.0f;
    float cosRefracted = sqrt(1.0f - sinSquared);
    float parallel = (cosIncident - eta * cosRefracted) / (cosIncident + eta * cosRefracted);
    float perpendicular = (eta * cosIncident - cosRefracted) / (eta * cosIncident + cosRefracted);
    return 1.0f - 0.5f * (parallel * parallel + perpendicular * perpendicular);
}

// Where a ray between a point `above` metres over flat water and one `below` metres under it, `across` metres
// apart horizontally, meets the surface: metres from the upper point's foot, [0, across]. `ior` is the water's.
// Snell's law as f(x) = sin(incident) - ior sin(refracted) = 0, which rises in x; Newton's step, or bisection
// where that leaves the bracket.
float flatCrossing(float above, float below, float across, float ior) {
    float low = 0.0f;
    float high = across;
    float x = across * above / max(above + below, float(1e-20f));
    for (int i = 0; i < 16; ++i) {
        float upper = sqrt(x * x + above * above);
        float lower = sqrt((across - x) * (across - x) + below * below);
        if (upper <= 0.0f || lower <= 0.0f) return x;
        float f = x / upper - ior * (across - x) / lower;
        float slope = above * above / (upper * upper * upper) + ior * below * below / (lower * lower * lower);
        if (f > 0.0f) high = x;
        else low = x;
        float next = x - f / max(slope, float(1e-20f));
        if (!(next > low && next < high)) next = 0.5f * (low + high);
        x = next;
    }
    return x;
}

// What is left of light after `metres` of water with extinction `perMetre` (absorption and scattering), thesis
// eq. 4-17 by colour channel.
vec3 extinction(vec3 perMetre, float metres) { return exp(-perMetre * max(metres, float(0.0f))); }
