// Draws the skin in colors that stand for its weights.
#ifndef INFLUENCE_PAIRS
#define INFLUENCE_PAIRS 0
#endif
#include "lib/influences.glsl"

in vec3 posedPosition;
in vec3 posedNormal;
// Encoded for the display; its alpha is not used.
in vec4 weightColor;

uniform mat4 sceneFromCharacter;
uniform mat4 clipFromScene;
// The palette entry of the joint whose skin keeps its colors while the rest is dimmed, or -1.
uniform int litEntry;

out vec3 scenePosition;
centroid out vec3 sceneNormal;
centroid out vec3 encodedColor;
out float share;

#define ADD_SHARE(entry, weight) if (int(entry) == litEntry) share += weight

void main() {
  share = 0.0;
  EACH_INFLUENCE(ADD_SHARE)
  vec4 position = sceneFromCharacter * vec4(posedPosition, 1.0);
  scenePosition = position.xyz;
  sceneNormal = mat3(sceneFromCharacter) * posedNormal;
  encodedColor = weightColor.rgb;
  gl_Position = clipFromScene * position;
}
