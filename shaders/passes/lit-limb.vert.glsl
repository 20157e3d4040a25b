// Draws the skin that follows one joint, over the skin as it was drawn.
#ifndef INFLUENCE_PAIRS
#define INFLUENCE_PAIRS 0
#endif
#include "lib/influences.glsl"

in vec3 posedPosition;
in vec3 posedNormal;

uniform mat4 sceneFromCharacter;
uniform mat4 clipFromScene;
// The joint's palette entry.
uniform int litEntry;

out vec3 scenePosition;
out vec3 sceneNormal;
// The joint's weight.
out float share;

#define ADD_SHARE(entry, weight) if (int(entry) == litEntry) share += weight

void main() {
  share = 0.0;
  EACH_INFLUENCE(ADD_SHARE)
  vec4 position = sceneFromCharacter * vec4(posedPosition, 1.0);
  scenePosition = position.xyz;
  sceneNormal = mat3(sceneFromCharacter) * posedNormal;
  gl_Position = clipFromScene * position;
}
