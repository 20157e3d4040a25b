#include "lib/color.glsl"

in vec3 scenePosition;
in vec3 sceneNormal;
in float share;

uniform vec3 eye;
uniform vec3 lightColor;
// The opacity of the light where the skin faces the viewer, and what its outline adds.
uniform float faceLight;
uniform float rimLight;

out vec4 color;

void main() {
  float facing = abs(dot(normalize(sceneNormal), normalize(eye - scenePosition)));
  float rim = (1.0 - facing) * (1.0 - facing);
  // The limb is where the joint has more weight than all others together, with soft ends.
  float limb = smoothstep(0.35, 0.65, share);
  color = vec4(encodeSrgb(lightColor), limb * min(1.0, faceLight + rimLight * rim));
}
