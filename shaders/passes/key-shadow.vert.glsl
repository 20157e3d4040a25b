// Draws the posed mesh as the key light sees it; only depth is kept.
in vec3 posedPosition;

uniform mat4 sceneFromCharacter;
uniform mat4 clipFromScene;

void main() {
  gl_Position = clipFromScene * (sceneFromCharacter * vec4(posedPosition, 1.0));
}
