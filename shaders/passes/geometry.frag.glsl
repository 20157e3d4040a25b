// Writes which triangle of which character a pixel shows, and where on it, as numbers.
flat in uint triangle;
in vec2 place;
in vec2 texturePosition;

// Counted from 1; 0 is nothing.
uniform int character;
uniform float opacity;
uniform bool textured;
uniform sampler2D colorTexture;

out uvec4 geometry;

void main() {
  float alpha = opacity;
  if (textured) alpha *= texture(colorTexture, texturePosition).a;
  if (alpha < 0.5) discard;
  geometry = uvec4(uint(character), triangle, floatBitsToUint(place.x), floatBitsToUint(place.y));
}
