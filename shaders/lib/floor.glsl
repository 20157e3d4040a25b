// The floor's surface: checks of two colors that fade into the backdrop.
#include "lib/color.glsl"
#include "lib/background.glsl"

uniform vec3 floorLight;
uniform vec3 floorDark;
uniform float checkSize;
uniform float fadeStart;
uniform float fadeEnd;
uniform float shadowStrength;
// The part of the light that the key light's shadow takes.
uniform float shadowDarkness;

// A square wave of period 2 has a triangle wave as its integral; the difference of the integral
// over the pixel's width is the wave as the pixel sees it.
vec2 triangleWave(vec2 x) {
  return abs(2.0 * fract(0.5 * x) - 1.0);
}

// Returns 0 and 1 on neighboring checks, and their mean where checks are smaller than pixels.
float checker(vec2 x) {
  vec2 width = max(fwidth(x), 1e-4);
  vec2 wave = (triangleWave(x + 0.5 * width) - triangleWave(x - 0.5 * width)) / width;
  return 0.5 + 0.5 * wave.x * wave.y;
}

// Returns how much of the floor is left at a place (x and z), where it fades.
float floorShare(vec2 place) {
  return 1.0 - smoothstep(fadeStart, fadeEnd, length(place));
}

// Returns the displayed color at a place of the floor, which this part of the light reaches. A
// picture that is cut out has nothing where the floor has faded.
vec4 floorColor(vec2 place, float light) {
  vec3 surface = mix(floorLight, floorDark, checker(place / checkSize));
  surface *= mix(1.0, light, shadowStrength);
  float share = floorShare(place);
#ifdef CUT_OUT
  return vec4(dither(encodeSrgb(surface)), 1.0) * share;
#else
  return vec4(dither(encodeSrgb(mix(backdrop(), surface, share))), 1.0);
#endif
}
