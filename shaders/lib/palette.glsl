// The palette has PALETTE_STRIDE rows of vec4 per entry. It is a uniform array (std140 block) of
// PALETTE_ROWS rows or, if PALETTE_ROWS is 0, a texture addressed linearly. Methods call paletteRow
// and do not know which it is.

#if PALETTE_ROWS > 0

layout(std140) uniform Palette {
  vec4 paletteRows[PALETTE_ROWS];
};

vec4 paletteRow(uint entry, int row) {
  return paletteRows[int(entry) * PALETTE_STRIDE + row];
}

#else

uniform sampler2D paletteTexture;

vec4 paletteRow(uint entry, int row) {
  int texel = int(entry) * PALETTE_STRIDE + row;
  return texelFetch(paletteTexture, ivec2(texel & 1023, texel >> 10), 0);
}

#endif
