#include "lib/color.glsl"

in vec3 lineColor;

uniform float opacity;

out vec4 color;

void main() {
  color = vec4(encodeSrgb(lineColor), opacity);
}
