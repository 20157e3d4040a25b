// Dual quaternion skinning (Kavan, Collins, Zara, O'Sullivan 2007): every vertex moves by one rigid
// motion, the normalized sum of s w q. This mirrors src/skinning/dual-quaternion.ts,
// blend-motions.ts and mix-vertices.ts. The palette has three rows of a matrix, then a dual
// quaternion, and perhaps three rows of a stretch.

#define ROTATION_ROW 3
#include "lib/quaternions.glsl"

// 0 for linear blend, 1 for dual quaternions.
uniform float blend;

vec4 blended0;
vec4 blended1;
vec4 blended2;

void accumulate(uint entry, float weight) {
  blended0 += weight * paletteRow(entry, 0);
  blended1 += weight * paletteRow(entry, 1);
  blended2 += weight * paletteRow(entry, 2);
}

vec4 blendedRotation;
vec4 blendedDual;

void accumulateMotion(uint entry, float weight) {
  vec4 rotation = paletteRow(entry, ROTATION_ROW);
  float share = signedWeight(rotation, weight);
  blendedRotation += share * rotation;
  blendedDual += share * paletteRow(entry, ROTATION_ROW + 1);
}

#if PALETTE_STRIDE > 5

vec4 stretch0;
vec4 stretch1;
vec4 stretch2;

void accumulateStretch(uint entry, float weight) {
  float clamped = weight > 0.0 ? weight : 0.0;
  stretch0 += clamped * paletteRow(entry, ROTATION_ROW + 2);
  stretch1 += clamped * paletteRow(entry, ROTATION_ROW + 3);
  stretch2 += clamped * paletteRow(entry, ROTATION_ROW + 4);
}

// Multiplies a row from the right by the mean stretch.
vec3 stretchRow(vec3 row) {
  return vec3(
    dotInOrder(row, vec3(stretch0.x, stretch1.x, stretch2.x)),
    dotInOrder(row, vec3(stretch0.y, stretch1.y, stretch2.y)),
    dotInOrder(row, vec3(stretch0.z, stretch1.z, stretch2.z))
  ) * (1.0 / stretch0.w);
}

#endif

// Writes the blended motion as a matrix by rows; returns false where it has no direction.
bool blendMotion(out vec4 row0, out vec4 row1, out vec4 row2) {
  FIND_PIVOT
  blendedRotation = vec4(0.0);
  blendedDual = vec4(0.0);
  EACH_INFLUENCE(accumulateMotion)
  float squared = dotInOrder(blendedRotation, blendedRotation);
  if (!(squared >= 1e-12)) return false;
  float scale = 1.0 / sqrt(squared);
  vec4 c = blendedRotation * scale;
  vec4 e = blendedDual * scale;
  vec3 turn0;
  vec3 turn1;
  vec3 turn2;
  rotationRows(c, turn0, turn1, turn2);
  vec3 translation = 2.0 * ((c.w * e.xyz - e.w * c.xyz) + crossInOrder(c.xyz, e.xyz));
#if PALETTE_STRIDE > 5
  stretch0 = vec4(0.0);
  stretch1 = vec4(0.0);
  stretch2 = vec4(0.0);
  EACH_INFLUENCE(accumulateStretch)
  turn0 = stretchRow(turn0);
  turn1 = stretchRow(turn1);
  turn2 = stretchRow(turn2);
#endif
  row0 = vec4(turn0, translation.x);
  row1 = vec4(turn1, translation.y);
  row2 = vec4(turn2, translation.z);
  return true;
}

void deform(vec3 position, vec3 normal, out vec3 outPosition, out vec3 outNormal) {
  vec4 row0;
  vec4 row1;
  vec4 row2;
  bool hasMotion = blend > 0.0 && blendMotion(row0, row1, row2);
  if (!hasMotion || blend < 1.0) {
    blended0 = vec4(0.0);
    blended1 = vec4(0.0);
    blended2 = vec4(0.0);
    EACH_INFLUENCE(accumulate)
  }
  if (!hasMotion) {
    row0 = blended0;
    row1 = blended1;
    row2 = blended2;
  }
  transformVertex(row0, row1, row2, position, normal, outPosition, outNormal);
  if (blend == 0.0 || blend == 1.0) return;
  vec3 otherPosition;
  vec3 otherNormal;
  transformVertex(blended0, blended1, blended2, position, normal, otherPosition, otherNormal);
  outPosition = flushSubnormal(otherPosition + blend * (outPosition - otherPosition));
  outNormal = makeUnit(flushSubnormal(otherNormal + blend * (outNormal - otherNormal)));
}
