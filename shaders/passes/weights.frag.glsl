in vec3 scenePosition;
centroid in vec3 sceneNormal;
centroid in vec3 encodedColor;
in float share;

uniform vec3 eye;
uniform float opacity;
uniform int litEntry;
// Whether the colors are those of the legend, without light.
uniform bool unlit;

out vec4 color;

// The color is scaled as it is encoded, so that its hue stays; where the skin faces the viewer from
// above, it is that of the legend.
float softLight() {
#ifdef FACETED
  vec3 normal = normalize(cross(dFdx(scenePosition), dFdy(scenePosition)));
#else
  vec3 normal = normalize(sceneNormal);
#endif
  float facing = abs(dot(normal, normalize(eye - scenePosition)));
  return mix(0.58, 1.0, facing) * mix(0.9, 1.0, 0.5 + 0.5 * normal.y);
}

void main() {
  vec3 shown = encodedColor;
  if (litEntry >= 0) {
    // What other joints own keeps a trace of its color on a gray of its lightness.
    float gray = mix(0.5, dot(shown, vec3(0.3, 0.59, 0.11)), 0.4);
    shown = mix(mix(vec3(gray), shown, 0.12), shown, smoothstep(0.02, 0.5, share));
  }
  color = vec4(unlit ? shown : shown * softLight(), opacity);
}
