// Draws the posed mesh as seen from below, projected straight onto the floor's square.
in vec3 posedPosition;

uniform mat4 sceneFromCharacter;
uniform vec3 contactSquare;

out float height;

void main() {
  vec3 position = (sceneFromCharacter * vec4(posedPosition, 1.0)).xyz;
  height = position.y;
  gl_Position = vec4((position.xz - contactSquare.xy) / contactSquare.z, 0.0, 1.0);
}
