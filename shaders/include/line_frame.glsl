// The camera that lines of light are drawn for. Positions in m from the scene's origin.
layout(std140, binding = 2) uniform LineFrame {
    mat4 viewProjection; // depth from 1 near by to 0 far away, w the metres along the view
    vec4 cameraPosition; // w: nearest w that is drawn, m
    vec4 target;         // pixels in x and y; pixels that a metre fills in x and y at a metre's distance
    vec4 lineWidth;      // x: least width, pixels; y: width of the piece of water that a line stands for, m
    vec4 strength;       // of the light, W per unit of flux; w: 0 Henyey and Greenstein, 1 Schlick
    vec4 scattering;     // RGB, 1/m; w: anisotropy
    vec4 extinctionPerMetre; // RGB
};

vec2 pixelOf(vec4 clip) { return 0.5 * (clip.xy / clip.w + 1.0) * target.xy; }

// A line is as wide as the light that it stands for, and at least as its setting says. At `w` metres along the view.
float widthAt(float w) { return max(lineWidth.x, lineWidth.y * 0.5 * (target.z + target.w) / w); }
