// These functions transform a vertex by a 3 × 4 matrix given by rows. They mirror
// src/skinning/affine-kernel.ts operation by operation: change one with the other.

vec3 flushSubnormal(vec3 v) {
  return mix(v, vec3(0.0), lessThan(abs(v), vec3(1.2e-38)));
}

float applyRow(vec4 row, vec3 p) {
  return ((row.x * p.x + row.y * p.y) + row.z * p.z) + row.w;
}

float dotInOrder(vec3 a, vec3 b) {
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

vec3 crossInOrder(vec3 a, vec3 b) {
  return vec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

vec3 transformPoint(vec4 row0, vec4 row1, vec4 row2, vec3 position) {
  return flushSubnormal(
    vec3(applyRow(row0, position), applyRow(row1, position), applyRow(row2, position))
  );
}

vec3 makeUnit(vec3 n) {
  float squared = dotInOrder(n, n);
  if (squared > 1e-30) return flushSubnormal(n * (1.0 / sqrt(squared)));
  return vec3(0.0, 1.0, 0.0);
}

// Transforms the normal by three rows and normalizes it.
vec3 transformNormal(vec3 row0, vec3 row1, vec3 row2, vec3 normal) {
  return makeUnit(
    vec3(dotInOrder(row0, normal), dotInOrder(row1, normal), dotInOrder(row2, normal))
  );
}

// The normal is transformed by the cofactors, which are the inverse transpose times the
// determinant, with the determinant's sign taken out again.
void transformVertex(
  vec4 row0, vec4 row1, vec4 row2,
  vec3 position, vec3 normal,
  out vec3 outPosition, out vec3 outNormal
) {
  outPosition = transformPoint(row0, row1, row2, position);
  vec3 cofactor0 = crossInOrder(row1.xyz, row2.xyz);
  vec3 cofactor1 = crossInOrder(row2.xyz, row0.xyz);
  vec3 cofactor2 = crossInOrder(row0.xyz, row1.xyz);
  float side = dotInOrder(cofactor0, row0.xyz) < 0.0 ? -1.0 : 1.0;
  outNormal = transformNormal(side * cofactor0, side * cofactor1, side * cofactor2, normal);
}
