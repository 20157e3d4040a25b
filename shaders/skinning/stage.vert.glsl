// Skinning is a stage of its own: it writes posed positions and normals to buffers that every pass
// draws.
#include "lib/palette.glsl"
#include "lib/influences.glsl"
#include "lib/affine.glsl"
#include "skinning/METHOD.glsl"

in vec3 restPosition;
in vec3 restNormal;

out vec3 posedPosition;
out vec3 posedNormal;

void main() {
  deform(restPosition, restNormal, posedPosition, posedNormal);
}
