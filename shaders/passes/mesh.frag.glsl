#include "lib/skin.glsl"

out vec4 color;

void main() {
  color = shadeSkin(vec4(albedo, opacity));
}
