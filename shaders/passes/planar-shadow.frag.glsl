#include "lib/floor.glsl"

in vec4 shadowPlace;
in float height;

out vec4 color;

void main() {
  // What is below the floor or above the light has no shadow.
  if (height < 0.0 || shadowPlace.w <= 0.0) discard;
  color = floorColor(shadowPlace.xz / shadowPlace.w, 1.0 - shadowDarkness);
}
