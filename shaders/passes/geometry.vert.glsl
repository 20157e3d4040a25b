// Draws the corners of triangles one by one, so that each knows its triangle and its place in it.
in vec3 cornerPosition;
in vec2 uv;

uniform mat4 sceneFromCharacter;
uniform mat4 clipFromScene;

flat out uint triangle;
// The weights of the second and the third corner.
out vec2 place;
out vec2 texturePosition;

void main() {
  int corner = gl_VertexID % 3;
  triangle = uint(gl_VertexID / 3);
  place = vec2(corner == 1 ? 1.0 : 0.0, corner == 2 ? 1.0 : 0.0);
  texturePosition = uv;
  gl_Position = clipFromScene * (sceneFromCharacter * vec4(cornerPosition, 1.0));
}
