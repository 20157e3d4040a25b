// This is skeletal subspace deformation, p' = sum of w T B^-1 p (6.837 handout, part 4): the
// matrices are blended first, left to right, and then applied once. This mirrors
// src/skinning/linear-blend.ts.

vec4 blended0;
vec4 blended1;
vec4 blended2;

void accumulate(uint entry, float weight) {
  blended0 += weight * paletteRow(entry, 0);
  blended1 += weight * paletteRow(entry, 1);
  blended2 += weight * paletteRow(entry, 2);
}

void deform(vec3 position, vec3 normal, out vec3 outPosition, out vec3 outNormal) {
  blended0 = vec4(0.0);
  blended1 = vec4(0.0);
  blended2 = vec4(0.0);
  EACH_INFLUENCE(accumulate)
  transformVertex(blended0, blended1, blended2, position, normal, outPosition, outNormal);
}
