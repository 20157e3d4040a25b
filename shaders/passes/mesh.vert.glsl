in vec3 posedPosition;
in vec3 posedNormal;
in vec2 uv;

uniform mat4 sceneFromCharacter;
uniform mat4 clipFromScene;

out vec3 scenePosition;
// At pixels that a triangle only touches, its normal must not be guessed beyond its rim.
centroid out vec3 sceneNormal;
out vec2 texturePosition;

void main() {
  vec4 position = sceneFromCharacter * vec4(posedPosition, 1.0);
  scenePosition = position.xyz;
  // The scene scales characters evenly, so that normals need no inverse transpose.
  sceneNormal = mat3(sceneFromCharacter) * posedNormal;
  texturePosition = uv;
  gl_Position = clipFromScene * position;
}
