// A picture may be drawn in tiles. These are its whole size, and the tile's lower left corner in it,
// in pixels.
uniform vec2 pictureSize;
uniform vec2 pictureOffset;
