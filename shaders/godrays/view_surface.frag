// 1 over metres along the view, in alpha.
out vec4 outFar;

void main() { outFar = vec4(0.0, 0.0, 0.0, gl_FragCoord.w); }
