// The palette: PALETTE_STRIDE rows of vec4 an entry, in a uniform array (std140 block) of
// PALETTE_ROWS rows, or, where PALETTE_ROWS is 0, in a texture addressed linearly. Methods call
// paletteRow and do not know which it is.

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
