// These functions blend the rotations of a vertex as quaternions. They mirror
// src/skinning/blend-quaternions.ts operation by operation: change one with the other. A method
// that includes this names the row of the palette that has the rotation, ROTATION_ROW.

vec4 pivot;
float pivotWeight;

float dotInOrder(vec4 a, vec4 b) {
  return ((a.x * b.x + a.y * b.y) + a.z * b.z) + a.w * b.w;
}

uint pivotEntry;

// Finds the largest weight, or the first of several equal ones.
void findPivot(uint entry, float weight) {
  if (weight > pivotWeight) {
    pivotWeight = weight;
    pivotEntry = entry;
  }
}

// Sets the pivot, in comparison with which signedWeight turns the other rotations.
#define FIND_PIVOT \
  pivotEntry = 0u; \
  pivotWeight = 0.0; \
  EACH_INFLUENCE(findPivot) \
  pivot = paletteRow(pivotEntry, ROTATION_ROW);

// Returns the weight of a rotation, which is negative if it points away from the pivot, since a
// quaternion and its opposite are the same rotation. Negative weights count as 0.
float signedWeight(vec4 rotation, float weight) {
  float clamped = weight > 0.0 ? weight : 0.0;
  return dotInOrder(pivot, rotation) < 0.0 ? -clamped : clamped;
}

// Returns the matrix of a unit quaternion xyzw, by rows.
void rotationRows(vec4 q, out vec3 row0, out vec3 row1, out vec3 row2) {
  vec3 twice = 2.0 * q.xyz;
  vec3 squares = q.xyz * twice;
  float xy = q.x * twice.y;
  float xz = q.x * twice.z;
  float yz = q.y * twice.z;
  vec3 turned = q.w * twice;
  row0 = vec3(1.0 - (squares.y + squares.z), xy - turned.z, xz + turned.y);
  row1 = vec3(xy + turned.z, 1.0 - (squares.x + squares.z), yz - turned.x);
  row2 = vec3(xz - turned.y, yz + turned.x, 1.0 - (squares.x + squares.y));
}
