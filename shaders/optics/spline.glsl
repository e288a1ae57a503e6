// Uniform cubic B-splines. In the language that GLSL and C++ share.

// Weights of the four coefficients around a place: `f` in [0, 1] is how far it lies from the second of them
// to the third. They are not negative and add up to 1, so that a spline stays within its coefficients.
vec4 splineWeights(float f) {
    float g = 1.0f - f;
    return vec4(g * g * g, 4.0f - 3.0f * f * f * (2.0f - f), 4.0f - 3.0f * g * g * (2.0f - g), f * f * f) / 6.0f;
}

// Their derivatives by f.
vec4 splineSlopes(float f) {
    float g = 1.0f - f;
    return vec4(-0.5f * g * g, f * (1.5f * f - 2.0f), g * (2.0f - 1.5f * g), 0.5f * f * f);
}
