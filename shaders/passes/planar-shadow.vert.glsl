// Projects the posed mesh along a light onto the floor.
in vec3 posedPosition;

uniform mat4 sceneFromCharacter;
uniform mat4 clipFromScene;
// The result is homogeneous; its w is positive where the light shines on the point from above.
uniform mat4 floorFromScene;

out vec4 shadowPlace;
// The height of the point above the floor.
out float height;

void main() {
  vec4 position = sceneFromCharacter * vec4(posedPosition, 1.0);
  shadowPlace = floorFromScene * position;
  height = position.y;
  gl_Position = clipFromScene * shadowPlace;
}
