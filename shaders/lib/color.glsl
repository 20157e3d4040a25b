#include "lib/picture.glsl"

// These functions convert linear light for the display with a shoulder that preserves hue and then
// the sRGB curve.

// The curve's power is fitted by two square roots, which cost less than a power. From 0 to 1 the fit
// is within 0.1 of one of the display's 255 steps.
vec3 encodeSrgb(vec3 linear) {
  vec3 root = sqrt(max(linear, vec3(0.0)));
  vec3 high = 0.8337522 * root + 0.2981091 * sqrt(root) - 0.0553168 * linear - 0.0769038;
  return mix(high, linear * 12.92, lessThan(linear, vec3(0.0031308)));
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
  vec2 p = floor(gl_FragCoord.xy) + pictureOffset;
  float noise = fract(52.9829189 * fract(dot(p, vec2(0.06711056, 0.00583715))));
  return encoded + (noise - 0.5) / 255.0;
}
