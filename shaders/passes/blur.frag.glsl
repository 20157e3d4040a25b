// One direction of a Gaussian blur, of different width for the two channels.
in vec2 textureAt;

uniform sampler2D source;
// Standard deviations along the direction, in texture coordinates: of red, and of green.
uniform vec2 redStep;
uniform vec2 greenStep;

out vec4 color;

void main() {
  vec2 sum = vec2(0.0);
  float total = 0.0;
  for (int i = -5; i <= 5; i++) {
    float at = float(i) * 0.5;
    float weight = exp(-0.5 * at * at);
    sum.r += weight * texture(source, textureAt + at * redStep).r;
    sum.g += weight * texture(source, textureAt + at * greenStep).g;
    total += weight;
  }
  color = vec4(sum / total, 0.0, 1.0);
}
