#include "lib/color.glsl"
#include "lib/studio.glsl"

in vec3 scenePosition;
in vec3 sceneNormal;
in vec3 solidColor;

// Below 1 for a solid that shows through what hides it.
uniform float opacity;
// 1 for round solids, 0 for those with flat faces.
uniform float rim;

out vec4 color;

void main() {
  vec3 normal = normalize(sceneNormal);
  vec3 view = normalize(eye - scenePosition);
  vec3 lit = shadeMatte(solidColor, normal, view, scenePosition);
  // A thin dark rim sets solids off from each other and from the skin.
  float outline = mix(1.0, smoothstep(0.12, 0.34, abs(dot(normal, view))), rim);
  color = vec4(dither(encodeSrgb(toneMap(lit * mix(0.12, 1.0, outline)))), opacity);
}
