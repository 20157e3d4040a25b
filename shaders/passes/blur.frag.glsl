// Applies one direction of a Gaussian blur, with a different width for each of the two channels.
in vec2 textureAt;

uniform sampler2D source;
// The standard deviations of red and green along the direction, in texture coordinates.
uniform vec2 redStep;
uniform vec2 greenStep;

out vec4 color;

// Samples are three quarters of a standard deviation apart, out to two and a quarter. The weights
// are the Gaussian at the samples, scaled so that all of them together sum to 1.
const float spacing = 0.75;
const float weights[4] = float[](0.3058, 0.2308, 0.0993, 0.0244);

vec2 at(vec2 shift) {
  return textureLod(source, textureAt + shift, 0.0).rg;
}

void main() {
  vec2 sum = weights[0] * at(vec2(0.0));
  for (int i = 1; i < 4; i++) {
    vec2 red = spacing * float(i) * redStep;
    vec2 green = spacing * float(i) * greenStep;
    sum += weights[i] * vec2(at(red).r + at(-red).r, at(green).g + at(-green).g);
  }
  color = vec4(sum, 0.0, 1.0);
}
