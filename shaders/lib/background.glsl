#include "lib/picture.glsl"

// The backdrop is a gradient over the height of the picture; the floor fades into it.
uniform vec3 backdropTop;
uniform vec3 backdropBottom;

vec3 backdrop() {
  float height = (gl_FragCoord.y + pictureOffset.y) / pictureSize.y;
  return mix(backdropBottom, backdropTop, smoothstep(0.0, 1.0, height));
}
