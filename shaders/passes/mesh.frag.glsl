#include "lib/skin.glsl"

// In linear light.
uniform vec3 albedo;
// Below 1, what is behind the surface shows through.
uniform float opacity;

out vec4 color;

void main() {
  color = shadeSkin(vec4(albedo, opacity));
}
