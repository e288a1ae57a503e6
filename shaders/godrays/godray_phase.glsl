// Share of what is scattered that goes a way, 1/sr.
#include "godrays/godray_frame.glsl"
#include "optics/phase.glsl"

float scatteredTowards(float cosTurn) {
    return strength.w > 0.5 ? schlickPhase(cosTurn, scattering.w) : henyeyGreenstein(cosTurn, scattering.w);
}
