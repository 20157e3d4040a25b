// The backdrop is a gradient over the height of the picture; the floor fades into it. If CHECKERED
// is defined, checks stand for transparency.
uniform vec3 backdropTop;
uniform vec3 backdropBottom;
uniform vec2 viewportSize;

vec3 backdrop() {
#ifdef CHECKERED
  vec2 at = floor(gl_FragCoord.xy * (60.0 / viewportSize.y));
  return mix(backdropBottom, backdropTop, mod(at.x + at.y, 2.0));
#else
  float height = gl_FragCoord.y / viewportSize.y;
  return mix(backdropBottom, backdropTop, smoothstep(0.0, 1.0, height));
#endif
}
