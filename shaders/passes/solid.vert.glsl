// Small solids, many in one draw: joints, bones, axes. Each instance has its own 3 × 4 matrix whose
// columns are orthogonal, and its color.
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
  // With orthogonal columns the inverse transpose is the matrix over its columns' squared lengths.
  vec3 squared = vec3(
    dot(sceneFromSolid[0], sceneFromSolid[0]),
    dot(sceneFromSolid[1], sceneFromSolid[1]),
    dot(sceneFromSolid[2], sceneFromSolid[2])
  );
  sceneNormal = sceneFromSolid * (normal / max(squared, 1e-20));
  solidColor = instanceColor;
  gl_Position = clipFromScene * vec4(scenePosition, 1.0);
}
