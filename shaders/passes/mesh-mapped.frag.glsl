// Covers the skin with an image, a checker, or the texture coordinates as colors. An image and a
// checker lie by texture coordinates, or are projected in the bind pose, so that they move with the
// skin.
#include "lib/skin.glsl"

in vec2 texturePosition;
in vec3 mappedPosition;
in vec3 mappedNormal;

uniform sampler2D colorTexture;
// 0 is the image, 1 the checker, 2 the texture coordinates.
uniform int pattern;
// 0 is by texture coordinates, 1 from the sides of a box, 2 around a cylinder.
uniform int projection;
uniform float repeats;

out vec4 color;

const float checks = 20.0;
const vec3 lightCheck = vec3(0.62, 0.6, 0.55);
const vec3 darkCheck = vec3(0.13, 0.17, 0.24);
const vec3 outsideTint = vec3(0.8, 0.0, 0.6);
const float fullTurn = 6.283185307179586;

// Returns the checker as it is seen through a box as wide as a pixel (Quilez, "Filtering the
// checkerboard pattern").
float checker(vec2 at, vec2 dx, vec2 dy) {
  vec2 width = max(abs(dx), abs(dy)) + 1e-4;
  vec2 a = abs(fract((at - 0.5 * width) * 0.5) - 0.5);
  vec2 b = abs(fract((at + 0.5 * width) * 0.5) - 0.5);
  vec2 sides = 2.0 * (a - b) / width;
  return 0.5 - 0.5 * sides.x * sides.y;
}

// Returns the pattern at a place of its plane. Derivatives are given because places jump at seams.
vec4 patternAt(vec2 at, vec2 dx, vec2 dy) {
  if (pattern == 0) return textureGrad(colorTexture, at, dx, dy);
  float light = checker(at * checks, dx * checks, dy * checks);
  return vec4(mix(darkCheck, lightCheck, light), 1.0);
}

// The width of the pattern divided by its height.
float aspect() {
  if (pattern != 0) return 1.0;
  vec2 size = vec2(textureSize(colorTexture, 0));
  return size.x / size.y;
}

// Returns the pattern on one side of the box. The places are measured from the middle of the
// character, or from its feet.
vec4 sideColor(vec2 place, vec2 middle, vec2 dx, vec2 dy) {
  vec2 scale = vec2(repeats / aspect(), repeats);
  return patternAt(place * scale + middle, dx * scale, dy * scale);
}

// Each side shows the pattern upright and unmirrored to someone who looks at it. An image fades from
// one side to the next; the checks of a checker would only turn gray.
vec4 boxColor(vec3 p, vec3 dx, vec3 dy) {
  vec3 normal = normalize(mappedNormal);
  vec3 side = mix(vec3(-1.0), vec3(1.0), step(0.0, normal));
  vec3 weight = abs(normal);
  if (pattern == 0) {
    weight *= weight;
    weight *= weight;
    weight *= weight;
  } else {
    weight = step(max(weight.x, max(weight.y, weight.z)), weight);
  }
  weight /= weight.x + weight.y + weight.z;
  vec2 turnX = vec2(-side.x, 1.0);
  vec2 turnY = vec2(1.0, -side.y);
  vec2 turnZ = vec2(side.z, 1.0);
  return weight.x * sideColor(p.zy * turnX, vec2(0.5, 0.0), dx.zy * turnX, dy.zy * turnX)
    + weight.y * sideColor(p.xz * turnY, vec2(0.5), dx.xz * turnY, dy.xz * turnY)
    + weight.z * sideColor(p.xy * turnZ, vec2(0.5, 0.0), dx.xy * turnZ, dy.xy * turnZ);
}

// The pattern goes around a whole number of times, so that its ends meet at the back.
vec4 cylinderColor(vec3 p, vec3 dx, vec3 dy) {
  float around = max(1.0, floor(repeats + 0.5));
  vec2 scale = vec2(around, repeats);
  float square = fullTurn * max(p.x * p.x + p.z * p.z, 1e-8);
  vec2 place = vec2(atan(p.x, p.z) / fullTurn + 0.5, p.y);
  vec2 placeX = vec2((p.z * dx.x - p.x * dx.z) / square, dx.y);
  vec2 placeY = vec2((p.z * dy.x - p.x * dy.z) / square, dy.y);
  return patternAt(place * scale, placeX * scale, placeY * scale);
}

// Red is u and green is v; what is outside of the picture is tinted.
vec4 coordinateColor() {
  vec2 outside = step(1e-4, abs(texturePosition - clamp(texturePosition, 0.0, 1.0)));
  vec3 inside = vec3(fract(texturePosition), 0.0);
  if (outside.x + outside.y == 0.0) inside.xy = texturePosition;
  return vec4(mix(inside, outsideTint, 0.6 * max(outside.x, outside.y)), 1.0);
}

void main() {
  vec2 uvX = dFdx(texturePosition) * repeats;
  vec2 uvY = dFdy(texturePosition) * repeats;
  vec3 placeX = dFdx(mappedPosition);
  vec3 placeY = dFdy(mappedPosition);
  vec4 covered;
  if (pattern == 2) covered = coordinateColor();
  else if (projection == 0) covered = patternAt(texturePosition * repeats, uvX, uvY);
  else if (projection == 1) covered = boxColor(mappedPosition, placeX, placeY);
  else covered = cylinderColor(mappedPosition, placeX, placeY);
  vec4 base = vec4(albedo, opacity) * covered;
  if (base.a < 0.002) discard;
  color = shadeSkin(base);
}
