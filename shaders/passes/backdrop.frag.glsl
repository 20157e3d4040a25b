#include "lib/color.glsl"
#include "lib/background.glsl"

out vec4 color;

void main() {
  color = vec4(dither(encodeSrgb(backdrop())), 1.0);
}
