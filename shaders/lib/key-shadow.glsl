// keyVisibility tells how much of the key light reaches a point: 0 in shadow, 1 in light, and
// values between them at soft edges.
uniform highp sampler2DShadow keyShadow;
uniform mat4 keyClipFromScene;

float keyVisibility(vec3 position, vec3 normal) {
  // The point is moved off the surface a little, so that the surface does not shadow itself where
  // light grazes it.
  vec3 at = (keyClipFromScene * vec4(position + normal * 0.004, 1.0)).xyz * 0.5 + 0.5;
  if (any(lessThan(at, vec3(0.0))) || any(greaterThan(at, vec3(1.0)))) return 1.0;
  // This averages four samples, each of which the sampler filters from four texels.
  vec2 texel = 1.25 / vec2(textureSize(keyShadow, 0));
  float sum = 0.0;
  for (int row = -1; row <= 1; row += 2) {
    for (int column = -1; column <= 1; column += 2) {
      sum += texture(keyShadow, vec3(at.xy + vec2(column, row) * texel, at.z));
    }
  }
  return 0.25 * sum;
}
