#include "lib/color.glsl"
#include "lib/background.glsl"

out vec4 color;

void main() {
  // The checks keep their size in drafts, whose pixels are larger.
  vec2 at = floor(gl_FragCoord.xy * (60.0 / pictureSize.y));
  color = vec4(encodeSrgb(mix(backdropBottom, backdropTop, mod(at.x + at.y, 2.0))), 1.0);
}
