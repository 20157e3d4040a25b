#include "lib/skin.glsl"

// Linear.
uniform vec3 albedo;
// Below 1 where what is behind shows through.
uniform float opacity;

out vec4 color;

void main() {
  color = shadeSkin(vec4(albedo, opacity));
}
