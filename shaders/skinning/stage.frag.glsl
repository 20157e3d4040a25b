// Nothing is rasterized; WebGL asks for a fragment shader all the same.
void main() {}
