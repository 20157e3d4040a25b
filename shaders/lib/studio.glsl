// The studio lights a matte surface with a warm key, a cool fill, a rim from behind, and a soft
// dome above a lit floor. Directions point to the light, in scene space, with unit length; colors
// are linear.
#include "lib/key-shadow.glsl"

uniform vec3 keyDirection;
uniform vec3 keyColor;
uniform vec3 fillDirection;
uniform vec3 fillColor;
uniform vec3 rimDirection;
uniform vec3 rimColor;
uniform vec3 ambientColor;
uniform vec3 eye;

const vec3 skyColor = vec3(0.84, 0.91, 1.0) * 0.4;
const vec3 groundColor = vec3(1.0, 0.92, 0.83) * 0.2;

// Light reaches this far past the terminator, as it does on clay. The value is the negative of a
// cosine.
const float wrap = 0.12;

// Lambert's cosine, which reaches a little past the terminator.
float wrapped(float cosine) {
  return max(0.0, (cosine + wrap) / (1.0 + wrap));
}

// Blinn's highlight: the part of a light that the surface reflects to the eye.
float highlight(vec3 toLight, vec3 view, vec3 normal, float shininess) {
  float along = max(dot(normal, normalize(toLight + view)), 1e-4);
  return pow(along, shininess) * step(0.0, dot(normal, toLight));
}

// Shades a matte surface that also has a highlight from key and fill, unless its exponent is 0.
// Normal and view have unit length.
vec3 shade(
  vec3 albedo, vec3 specular, float shininess, vec3 normal, vec3 view, vec3 position
) {
  float up = 0.5 + 0.5 * normal.y;
  vec3 light = ambientColor * mix(groundColor, skyColor, up);
  light += fillColor * wrapped(dot(normal, fillDirection));
  light += rimColor * wrapped(dot(normal, rimDirection));
  float across = 1.0 - max(dot(normal, view), 0.0);
  across *= across;
  vec3 gloss = rimColor * (0.35 * across * across * up);
  // A surface that the light does not reach needs no shadow lookup.
  float facing = dot(normal, keyDirection);
  float visibility = facing > -wrap ? keyVisibility(position, normal) : 0.0;
  if (visibility > 0.0) {
    light += keyColor * (wrapped(facing) * visibility);
    // The sheen is the 28th power of the cosine.
    float sheen = max(dot(normal, normalize(keyDirection + view)), 0.0);
    sheen *= sheen;
    sheen *= sheen;
    float squared = sheen * sheen;
    gloss += keyColor * (0.06 * visibility * squared * squared * squared * sheen);
  }
  if (shininess > 0.0) {
    vec3 glint = keyColor * highlight(keyDirection, view, normal, shininess) * visibility;
    glint += fillColor * highlight(fillDirection, view, normal, shininess);
    gloss += specular * glint;
  }
  return albedo * light + gloss;
}

vec3 shadeMatte(vec3 albedo, vec3 normal, vec3 view, vec3 position) {
  return shade(albedo, vec3(0.0), 0.0, normal, view, position);
}
