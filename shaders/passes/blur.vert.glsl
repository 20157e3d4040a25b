out vec2 textureAt;

void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  textureAt = corner * 0.5 + 0.5;
  gl_Position = vec4(corner, 0.0, 1.0);
}
