// Every vertex follows only its heaviest joint, or the first of several equal ones (6.837 handout,
// part 4, the figure of colliding parts). This mirrors src/skinning/rigid.ts.

uint heaviestEntry;
float heaviestWeight;

void compare(uint entry, float weight) {
  if (weight > heaviestWeight) {
    heaviestWeight = weight;
    heaviestEntry = entry;
  }
}

void deform(vec3 position, vec3 normal, out vec3 outPosition, out vec3 outNormal) {
  heaviestEntry = 0u;
  heaviestWeight = 0.0;
  EACH_INFLUENCE(compare)
  transformVertex(
    paletteRow(heaviestEntry, 0), paletteRow(heaviestEntry, 1), paletteRow(heaviestEntry, 2),
    position, normal, outPosition, outNormal
  );
}
