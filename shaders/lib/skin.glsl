// Shades the posed skin in the studio's light, with the highlight of its material: faceted if
// FACETED is defined, and otherwise smooth.
#include "lib/color.glsl"
#include "lib/studio.glsl"

in vec3 scenePosition;
centroid in vec3 sceneNormal;

// In linear light.
uniform vec3 albedo;
// Below 1, what is behind the surface shows through.
uniform float opacity;
// The color of the material's highlight and its exponent, which is 0 if it has none.
uniform vec3 specular;
uniform float shininess;

// Returns the displayed color of a surface with this base color (linear) and opacity.
vec4 shadeSkin(vec4 base) {
  vec3 view = normalize(eye - scenePosition);
#ifdef FACETED
  // The face normal comes from neighboring pixels, which gives the assignment's look without a
  // second mesh.
  vec3 normal = normalize(cross(dFdx(scenePosition), dFdy(scenePosition)));
#else
  vec3 normal = normalize(sceneNormal);
  // Open surfaces show their inner side, where normals are flipped. Where a surface curves away,
  // slivers of its far side show too; their normals are nearly perpendicular to the view and must
  // stay.
  if (!gl_FrontFacing && dot(normal, view) < -0.3) normal = -normal;
#endif
  vec3 lit = shade(base.rgb, specular, shininess, normal, view, scenePosition);
  return vec4(dither(encodeSrgb(toneMap(lit))), base.a);
}
