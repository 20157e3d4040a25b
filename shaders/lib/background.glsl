// The backdrop is a gradient over the height of the picture; the floor fades into it.
uniform vec3 backdropTop;
uniform vec3 backdropBottom;
uniform vec2 viewportSize;

vec3 backdrop() {
  float height = gl_FragCoord.y / viewportSize.y;
  return mix(backdropBottom, backdropTop, smoothstep(0.0, 1.0, height));
}
