// Nothing is rasterized, but WebGL requires a fragment shader.
void main() {}
