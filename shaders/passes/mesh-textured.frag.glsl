#include "lib/skin.glsl"

in vec2 texturePosition;

// Linear; the texture is multiplied in, repeated beyond its edges.
uniform vec3 albedo;
// Below 1 where what is behind shows through.
uniform float opacity;
uniform sampler2D colorTexture;

out vec4 color;

void main() {
  vec4 base = vec4(albedo, opacity) * texture(colorTexture, texturePosition);
  // What can't be seen hides nothing either. A surface without a texture has a program of its own, since
  // a shader that may discard keeps depth tests from coming first.
  if (base.a < 0.002) discard;
  color = shadeSkin(base);
}
