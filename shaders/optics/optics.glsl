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
// apart horizontally, meets the surface: metres from the upper point's foot, [0, across]. `ior` >= 1 is the water's.
// With u the tangent of the incident angle, Snell's law makes the ray go
//     across(u) = above u + below u / sqrt(n² + (n² - 1) u²),
// which rises and is concave, so Newton's method closes in from the left without overshooting. Two bounds give a
// start near the root: the curve lies below its tangent at 0, and the lower part never exceeds the critical angle.
// (Newton on the place itself, guarded by bisection, was 0.3 off in the sine for a point light near the water.)
float flatCrossing(float above, float below, float across, float ior) {
    float high = max(above, float(1e-9f));
    float n2 = ior * ior;
    float widest = below / sqrt(max(n2 - 1.0f, float(1e-12f)));
    float u = max(across / (high + below / ior), (across - widest) / high);
    for (int i = 0; i < 10; ++i) {
        float w = n2 + (n2 - 1.0f) * u * u;
        float root = sqrt(w);
        float reached = high * u + below * u / root;
        u += max(across - reached, float(0.0f)) / (high + below * n2 / (w * root));
    }
    return clamp(high * u, float(0.0f), across);
}

// What is left of light after `metres` of water with extinction `perMetre` (absorption and scattering), thesis
// eq. 4-17 by colour channel.
vec3 extinction(vec3 perMetre, float metres) { return exp(-perMetre * max(metres, float(0.0f))); }
