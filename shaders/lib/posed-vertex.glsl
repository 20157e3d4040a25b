in vec3 posedPosition;
in vec3 posedNormal;
in vec2 uv;

uniform mat4 sceneFromCharacter;
uniform mat4 clipFromScene;

out vec3 scenePosition;
// At pixels that a triangle only partly covers, its normal must not be extrapolated beyond its
// edge.
centroid out vec3 sceneNormal;
out vec2 texturePosition;

void placeVertex() {
  vec4 position = sceneFromCharacter * vec4(posedPosition, 1.0);
  scenePosition = position.xyz;
  // The scene scales characters uniformly, so normals need no inverse transpose.
  sceneNormal = mat3(sceneFromCharacter) * posedNormal;
  texturePosition = uv;
  gl_Position = clipFromScene * position;
}
