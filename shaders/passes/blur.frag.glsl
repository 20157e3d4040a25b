// One direction of a Gaussian blur, of different width for the two channels.
in vec2 textureAt;

uniform sampler2D source;
// Standard deviations along the direction, in texture coordinates: of red, and of green.
uniform vec2 redStep;
uniform vec2 greenStep;

out vec4 color;

// Samples lie three quarters of a deviation apart, out to two and a quarter; the Gaussian there, and all
// of them together make 1.
const float spacing = 0.75;
const float weights[4] = float[](0.3058, 0.2308, 0.0993, 0.0244);

void main() {
  vec2 sum = weights[0] * texture(source, textureAt).rg;
  for (int i = 1; i < 4; i++) {
    vec2 red = spacing * float(i) * redStep;
    vec2 green = spacing * float(i) * greenStep;
    sum.r += weights[i] * (texture(source, textureAt + red).r + texture(source, textureAt - red).r);
    sum.g += weights[i] * (texture(source, textureAt + green).g + texture(source, textureAt - green).g);
  }
  color = vec4(sum, 0.0, 1.0);
}
