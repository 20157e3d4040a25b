// This is linear blend as CSE169 (project 2) asks for it: each joint turns the normal on its own,
// n' = sum of w (W B^-1)^-T n. The palette has three rows of W B^-1, then three of the inverse
// transpose. This mirrors src/skinning/joint-normals.ts.

vec4 blended0;
vec4 blended1;
vec4 blended2;
vec4 turned0;
vec4 turned1;
vec4 turned2;

void accumulate(uint entry, float weight) {
  blended0 += weight * paletteRow(entry, 0);
  blended1 += weight * paletteRow(entry, 1);
  blended2 += weight * paletteRow(entry, 2);
  turned0 += weight * paletteRow(entry, 3);
  turned1 += weight * paletteRow(entry, 4);
  turned2 += weight * paletteRow(entry, 5);
}

void deform(vec3 position, vec3 normal, out vec3 outPosition, out vec3 outNormal) {
  blended0 = vec4(0.0);
  blended1 = vec4(0.0);
  blended2 = vec4(0.0);
  turned0 = vec4(0.0);
  turned1 = vec4(0.0);
  turned2 = vec4(0.0);
  EACH_INFLUENCE(accumulate)
  outPosition = transformPoint(blended0, blended1, blended2, position);
  outNormal = transformNormal(turned0.xyz, turned1.xyz, turned2.xyz, normal);
}
