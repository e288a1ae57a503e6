// Out, added: irradiance for 1 W/m² of light, as the area that a texel's light comes from.
in vec2 before;
out vec4 irradiance;

void main() {
    vec2 x = dFdx(before), y = dFdy(before);
    irradiance = vec4(abs(x.x * y.y - x.y * y.x));
}
