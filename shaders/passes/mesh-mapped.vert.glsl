#include "lib/posed-vertex.glsl"

in vec3 bindPosition;
in vec3 bindNormal;

// The point of the bind pose that is mapped to (0, 0, 0), and the factor to a height of one.
uniform vec3 mapOrigin;
uniform float mapScale;

out vec3 mappedPosition;
out vec3 mappedNormal;

void main() {
  placeVertex();
  mappedPosition = (bindPosition - mapOrigin) * mapScale;
  mappedNormal = bindNormal;
}
