// Draws many small solids in one draw call: joints, bones and axes. Each instance has its own color
// and its own 3 × 4 matrix, whose columns are orthogonal.
in vec3 position;
in vec3 normal;
in vec4 instanceRow0;
in vec4 instanceRow1;
in vec4 instanceRow2;
in vec3 instanceColor;

uniform mat4 clipFromScene;

out vec3 scenePosition;
out vec3 sceneNormal;
out vec3 solidColor;

void main() {
  vec4 local = vec4(position, 1.0);
  scenePosition = vec3(
    dot(instanceRow0, local), dot(instanceRow1, local), dot(instanceRow2, local)
  );
  mat3 sceneFromSolid = transpose(mat3(instanceRow0.xyz, instanceRow1.xyz, instanceRow2.xyz));
  // Because the columns are orthogonal, the inverse transpose is the matrix with each column
  // divided by its squared length.
  vec3 squared = vec3(
    dot(sceneFromSolid[0], sceneFromSolid[0]),
    dot(sceneFromSolid[1], sceneFromSolid[1]),
    dot(sceneFromSolid[2], sceneFromSolid[2])
  );
  sceneNormal = sceneFromSolid * (normal / max(squared, 1e-20));
  solidColor = instanceColor;
  gl_Position = clipFromScene * vec4(scenePosition, 1.0);
}
