// Share of a spot's intensity in a direction, [0, 1], by the cosine of its angle to the spot's axis: 1 within the inner
// cone, 0 outside of the outer one (KHR_lights_punctual, "Inner and Outer Cone Angles").
float coneShare(float cosAngle, float cosInner, float cosOuter) {
    float scale = 1.0f / max(float(0.001f), cosInner - cosOuter);
    float share = clamp((cosAngle - cosOuter) * scale, float(0.0f), float(1.0f));
    return share * share;
}
