// The shadow is darker the nearer a surface is to the floor. It fades quickly for contact (red) and
// gently for the body above (green).
in float height;

out vec4 color;

void main() {
  float above = max(height, 0.0);
  color = vec4(exp(-above / 0.035), exp(-above / 0.45), 0.0, 1.0);
}
