// Shades the posed skin in the studio's light, smooth or faceted.
#include "lib/color.glsl"
#include "lib/studio.glsl"

in vec3 scenePosition;
centroid in vec3 sceneNormal;

// In linear light.
uniform vec3 albedo;
// Below 1, what is behind the surface shows through.
uniform float opacity;
// The color of the material's highlight, black if it has none, and its exponent.
uniform vec3 specular;
uniform float shininess;
uniform bool faceted;

// Returns the displayed color of a surface with this base color (linear) and opacity.
vec4 shadeSkin(vec4 base) {
  // The face normal comes from neighboring pixels, which gives the assignment's look without a
  // second mesh.
  vec3 face = normalize(cross(dFdx(scenePosition), dFdy(scenePosition)));
  // Open surfaces show their inner side, where normals are flipped. Where a closed surface curves
  // away, slivers of its far side show too; their normals are nearly perpendicular to the view and
  // must stay.
  vec3 smoothed = normalize(sceneNormal);
  bool inner = !gl_FrontFacing && dot(smoothed, normalize(eye - scenePosition)) < -0.3;
  if (inner) smoothed = -smoothed;
  vec3 normal = faceted ? face : smoothed;
  vec3 lit = shade(base.rgb, specular, shininess, normal, scenePosition);
  return vec4(dither(encodeSrgb(toneMap(lit))), base.a);
}
