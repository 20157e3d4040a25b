#include "lib/color.glsl"
#include "lib/studio.glsl"

in vec3 scenePosition;
centroid in vec3 sceneNormal;
in vec2 texturePosition;

// Linear; a texture is multiplied in, repeated beyond its edges.
uniform vec3 albedo;
// Of the material's highlight, black where it has none, and its exponent.
uniform vec3 specular;
uniform float shininess;
uniform bool textured;
uniform sampler2D colorTexture;
uniform bool faceted;
// Below 1 where what is behind shows through.
uniform float opacity;

out vec4 color;

void main() {
  // The face's own normal, from neighboring pixels: the assignment's look without a second mesh.
  vec3 face = normalize(cross(dFdx(scenePosition), dFdy(scenePosition)));
  // Of open surfaces the inner side shows, its normals turned. Where a closed one curves away, slivers
  // of its far side show too; their normals lie nearly across the view and must stay.
  vec3 smoothed = normalize(sceneNormal);
  bool inner = !gl_FrontFacing && dot(smoothed, normalize(eye - scenePosition)) < -0.3;
  if (inner) smoothed = -smoothed;
  vec3 normal = faceted ? face : smoothed;
  vec4 base = vec4(albedo, opacity);
  if (textured) base *= texture(colorTexture, texturePosition);
  // What can't be seen hides nothing either.
  if (base.a < 0.002) discard;
  vec3 lit = shade(base.rgb, specular, shininess, normal, scenePosition);
  color = vec4(dither(encodeSrgb(toneMap(lit))), base.a);
}
