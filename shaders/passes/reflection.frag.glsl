#include "lib/floor.glsl"

in vec3 scenePosition;

// The size of the mirrored picture, which may be a tile of a larger one.
uniform vec2 viewportSize;
uniform vec3 eye;
// The mirrored scene as it is displayed, upside down, with colors multiplied by their alpha.
uniform sampler2D mirrored;
// The strength, 0 to 1.
uniform float reflection;

out vec4 color;

void main() {
  vec2 at = gl_FragCoord.xy / viewportSize;
  vec4 seen = textureLod(mirrored, vec2(at.x, 1.0 - at.y), 0.0);
  // Schlick's approximation of Fresnel's equations, for a refractive index of 1.5.
  float fresnel = 0.04 + 0.96 * pow(1.0 - normalize(eye - scenePosition).y, 5.0);
  color = seen * (reflection * fresnel * floorShare(scenePosition.xz));
}
