// Draws a square of the plane y = 0 around the origin, in scene space.
uniform mat4 clipFromScene;
uniform float halfSize;

out vec3 scenePosition;

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  scenePosition = vec3(corner.x, 0.0, -corner.y) * halfSize;
  gl_Position = clipFromScene * vec4(scenePosition, 1.0);
}
