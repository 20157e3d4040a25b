// keyVisibility tells how much of the key light reaches a point: 0 in shadow, 1 in light, and
// values between them at soft edges.
uniform highp sampler2DShadow keyShadow;
uniform mat4 keyClipFromScene;
// Three and a half texels of the map, in scene units.
uniform float keyShadowStep;

// The map has one level, and naming it saves finding one.
float keySample(vec3 at, vec2 shift) {
  return textureLod(keyShadow, vec3(at.xy + shift, at.z), 0.0);
}

float keyVisibility(vec3 position, vec3 normal) {
  // The point is moved off the surface by more than the samples reach, so that the surface does
  // not shadow itself where light grazes it.
  vec3 at = (keyClipFromScene * vec4(position + normal * keyShadowStep, 1.0)).xyz * 0.5 + 0.5;
  if (any(lessThan(at, vec3(0.0))) || any(greaterThan(at.xy, vec2(1.0)))) return 1.0;
  // A low light's shadow reaches beyond the map's depth.
  at.z = min(at.z, 1.0);
  // This averages four samples, each of which the sampler filters from four texels.
  vec2 texel = 1.25 / vec2(textureSize(keyShadow, 0));
  float below = keySample(at, -texel) + keySample(at, vec2(texel.x, -texel.y));
  float above = keySample(at, vec2(-texel.x, texel.y)) + keySample(at, texel);
  return 0.25 * (below + above);
}
