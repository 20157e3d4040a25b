#include "lib/posed-vertex.glsl"

void main() {
  placeVertex();
}
