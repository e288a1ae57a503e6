// How light that the water scatters is spread over directions, 1/sr; over all of them it is 1. In the language that GLSL
// and C++ share. `cosTurn` is the cosine of the angle between the ways before and after, `g` its mean.

// Henyey and Greenstein 1941.
float henyeyGreenstein(float cosTurn, float g) {
    float below = 1.0f + g * g - 2.0f * g * cosTurn;
    return (1.0f - g * g) / (12.566370614359172f * below * sqrt(below));
}

// The same without a root (Blasi, Le Saec and Schlick 1993): what "a simplified version" stands for.
float schlickPhase(float cosTurn, float g) {
    float k = 1.55f * g - 0.55f * g * g * g, below = 1.0f - k * cosTurn;
    return (1.0f - k * k) / (12.566370614359172f * below * below);
}
