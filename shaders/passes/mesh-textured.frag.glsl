#include "lib/skin.glsl"

in vec2 texturePosition;

// It is multiplied in, and repeats beyond its edges.
uniform sampler2D colorTexture;

out vec4 color;

void main() {
  vec4 base = vec4(albedo, opacity) * texture(colorTexture, texturePosition);
  // A fragment that can't be seen must not hide anything either. Surfaces without a texture have a
  // program of their own, because a shader that may discard prevents early depth tests.
  if (base.a < 0.002) discard;
  color = shadeSkin(base);
}
