// These functions convert linear light for the display with a shoulder that preserves hue and then
// the sRGB curve.

vec3 encodeSrgb(vec3 linear) {
  vec3 low = linear * 12.92;
  vec3 high = 1.055 * pow(max(linear, vec3(0.0)), vec3(1.0 / 2.4)) - 0.055;
  return mix(high, low, lessThan(linear, vec3(0.0031308)));
}

// Colors up to 0.75 stay as they are. Above that, the brightest channel eases toward 1 and the
// others are scaled along with it.
vec3 toneMap(vec3 linear) {
  float peak = max(linear.r, max(linear.g, linear.b));
  if (peak <= 0.75) return linear;
  float eased = 0.75 + 0.25 * (1.0 - exp((0.75 - peak) / 0.25));
  return linear * (eased / peak);
}

// Adds up to half a step of noise, fixed to the pixel, so that gentle gradients show no banding.
vec3 dither(vec3 encoded) {
  vec2 p = floor(gl_FragCoord.xy);
  float noise = fract(52.9829189 * fract(dot(p, vec2(0.06711056, 0.00583715))));
  return encoded + (noise - 0.5) / 255.0;
}
