// Each point turns about its own center, which moves as under linear blend (Le and Hodgins 2016):
// p' = R(q) (p - p*) + A p* + t. An entry of the palette has three rows of its matrix, its rotation
// and, if bind matrices stretch, three rows of that. This mirrors
// src/skinning/centers-of-rotation.ts, and positive-skin.ts for negative weights.
#define ROTATION_ROW 3
#include "lib/quaternions.glsl"

in vec3 restCenter;

vec4 blended0;
vec4 blended1;
vec4 blended2;
vec4 turned;
#if PALETTE_STRIDE > 4
vec4 stretch0;
vec4 stretch1;
vec4 stretch2;
#endif

float total;
float lowest;
float scale;

void measure(uint entry, float weight) {
  total += weight > 0.0 ? weight : 0.0;
  lowest = min(lowest, weight);
}

void accumulate(uint entry, float weight) {
  float share = (weight > 0.0 ? weight : 0.0) * scale;
  blended0 += share * paletteRow(entry, 0);
  blended1 += share * paletteRow(entry, 1);
  blended2 += share * paletteRow(entry, 2);
  vec4 rotation = paletteRow(entry, ROTATION_ROW);
  turned += signedWeight(rotation, share) * rotation;
#if PALETTE_STRIDE > 4
  stretch0 += share * paletteRow(entry, 4);
  stretch1 += share * paletteRow(entry, 5);
  stretch2 += share * paletteRow(entry, 6);
#endif
}

#if PALETTE_STRIDE > 4
// Multiplies a row of a rotation by the stretch that comes before it, a mean over the weights, whose
// sum is behind its first row.
vec3 stretchFirst(vec3 row) {
  return (1.0 / stretch0.w) * vec3(
    dotInOrder(row, vec3(stretch0.x, stretch1.x, stretch2.x)),
    dotInOrder(row, vec3(stretch0.y, stretch1.y, stretch2.y)),
    dotInOrder(row, vec3(stretch0.z, stretch1.z, stretch2.z))
  );
}
#endif

void deform(vec3 position, vec3 normal, out vec3 outPosition, out vec3 outNormal) {
  blended0 = vec4(0.0);
  blended1 = vec4(0.0);
  blended2 = vec4(0.0);
  turned = vec4(0.0);
#if PALETTE_STRIDE > 4
  stretch0 = vec4(0.0);
  stretch1 = vec4(0.0);
  stretch2 = vec4(0.0);
#endif
  total = 0.0;
  lowest = 0.0;
  EACH_INFLUENCE(measure)
  // Without a positive weight the vertex follows the first entry, which is the pivot then.
  scale = lowest < 0.0 ? 1.0 / total : 1.0;
  FIND_PIVOT
  if (total == 0.0) {
    scale = 1.0;
    accumulate(0u, 1.0);
  } else {
    EACH_INFLUENCE(accumulate)
  }

  float squared = dotInOrder(turned, turned);
  vec3 place = position;
  // A point without a center has a huge one. It moves as under linear blend, and so does a point
  // whose rotations cancel out.
  if (restCenter.x < 1e38 && squared > 1e-12) {
    vec3 row0;
    vec3 row1;
    vec3 row2;
    rotationRows(turned * (1.0 / sqrt(squared)), row0, row1, row2);
#if PALETTE_STRIDE > 4
    row0 = stretchFirst(row0);
    row1 = stretchFirst(row1);
    row2 = stretchFirst(row2);
#endif
    blended0 = vec4(row0, applyRow(blended0, restCenter));
    blended1 = vec4(row1, applyRow(blended1, restCenter));
    blended2 = vec4(row2, applyRow(blended2, restCenter));
    place = position - restCenter;
  }
  transformVertex(blended0, blended1, blended2, place, normal, outPosition, outNormal);
}
