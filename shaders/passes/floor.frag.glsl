#include "lib/floor.glsl"
#include "lib/key-shadow.glsl"

in vec3 scenePosition;

uniform vec3 keyDirection;

// The contact (red) and broad (green) shadow over a square. contactSquare is the square's center in
// x and z, and half its side.
uniform sampler2D contactShadow;
uniform vec3 contactSquare;
uniform float contactStrength;

out vec4 color;

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
  // The floor casts no shadow on itself; moved off it, a low light's shadow would leave the feet.
  vec3 offset = vec3(0.0, clamp(1.35 * keyDirection.y, 0.0, 1.0), 0.0);
  float shade = 1.0 - keyVisibility(vec3(place.x, 0.0, place.y), offset);
  return (1.0 - 0.6 * contact.r) * (1.0 - 0.35 * contact.g) * (1.0 - shadowDarkness * shade);
}

void main() {
  vec2 place = scenePosition.xz;
  color = floorColor(place, lightAt(place));
}
