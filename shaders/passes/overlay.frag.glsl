#include "lib/color.glsl"

in vec4 lineColor;

uniform float opacity;

out vec4 color;

void main() {
  color = vec4(encodeSrgb(lineColor.rgb), lineColor.a * opacity);
}
