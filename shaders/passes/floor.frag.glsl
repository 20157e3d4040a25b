#include "lib/color.glsl"
#include "lib/background.glsl"
#include "lib/key-shadow.glsl"

in vec3 scenePosition;

uniform vec3 floorLight;
uniform vec3 floorDark;
uniform float checkSize;
uniform float fadeStart;
uniform float fadeEnd;
// The contact (red) and broad (green) shadow over a square. contactSquare is the square's center in
// x and z, and half its side.
uniform sampler2D contactShadow;
uniform vec3 contactSquare;
uniform float contactStrength;
uniform float shadowStrength;

out vec4 color;

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

// Returns how much light the characters leave to the floor.
float lightAt(vec2 place) {
  vec2 at = abs(place - contactSquare.xy) / contactSquare.z;
  vec2 contact = vec2(0.0);
  if (max(at.x, at.y) < 1.0) {
    vec2 within = (place - contactSquare.xy) / contactSquare.z * 0.5 + 0.5;
    // The square's rim is never quite empty; ease it out so that no edge shows.
    vec2 inside = smoothstep(1.0, 0.8, at);
    contact = textureLod(contactShadow, within, 0.0).rg * inside.x * inside.y * contactStrength;
  }
  float shade = 1.0 - keyVisibility(vec3(place.x, 0.0, place.y), vec3(0.0, 1.0, 0.0));
  return (1.0 - 0.6 * contact.r) * (1.0 - 0.35 * contact.g) * (1.0 - 0.22 * shade);
}

void main() {
  vec2 place = scenePosition.xz;
  vec3 surface = mix(floorLight, floorDark, checker(place / checkSize));
  surface *= mix(1.0, lightAt(place), shadowStrength);
  float fade = smoothstep(fadeStart, fadeEnd, length(place));
  color = vec4(dither(encodeSrgb(mix(surface, backdrop(), fade))), 1.0);
}
