// Marks one posed vertex by a ring of a constant size.
in vec3 posedPosition;

uniform mat4 sceneFromCharacter;
uniform mat4 clipFromScene;
uniform float size;

void main() {
  gl_Position = clipFromScene * (sceneFromCharacter * vec4(posedPosition, 1.0));
  // The vertex lies in the surface, which must not hide half of its ring.
  gl_Position.z -= 0.002 * gl_Position.w;
  gl_PointSize = size;
}
