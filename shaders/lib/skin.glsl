// The posed skin in the studio's light, smooth or faceted.
#include "lib/color.glsl"
#include "lib/studio.glsl"

in vec3 scenePosition;
centroid in vec3 sceneNormal;

// Of the material's highlight, black where it has none, and its exponent.
uniform vec3 specular;
uniform float shininess;
uniform bool faceted;

// What is seen of a surface of this color (linear) and opacity.
vec4 shadeSkin(vec4 base) {
  // The face's own normal, from neighboring pixels: the assignment's look without a second mesh.
  vec3 face = normalize(cross(dFdx(scenePosition), dFdy(scenePosition)));
  // Of open surfaces the inner side shows, its normals turned. Where a closed one curves away, slivers
  // of its far side show too; their normals lie nearly across the view and must stay.
  vec3 smoothed = normalize(sceneNormal);
  bool inner = !gl_FrontFacing && dot(smoothed, normalize(eye - scenePosition)) < -0.3;
  if (inner) smoothed = -smoothed;
  vec3 normal = faceted ? face : smoothed;
  vec3 lit = shade(base.rgb, specular, shininess, normal, scenePosition);
  return vec4(dither(encodeSrgb(toneMap(lit))), base.a);
}
