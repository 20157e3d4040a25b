// Draws many lines of any width in one draw call: bones as segments along +y, and grids of lines
// that are wrapped around +y to cylinders (x turns once from 0 to 1). A line has four vertices, two
// at each end, which are moved apart in the picture. Each instance has its own 3 × 4 matrix and its
// color.
in vec3 position;
in vec3 otherEnd;
in vec4 instanceRow0;
in vec4 instanceRow1;
in vec4 instanceRow2;
in vec3 instanceColor;

uniform mat4 clipFromScene;
uniform vec2 viewportSize;
uniform bool wrapped;
// In pixels.
uniform float lineWidth;

out vec3 lineColor;

const float fullTurn = 6.283185307179586;

vec4 clipPlace(vec3 place) {
  float around = place.x * fullTurn;
  vec4 local = vec4(wrapped ? vec3(cos(around), place.y, sin(around)) : place, 1.0);
  vec3 scene = vec3(
    dot(instanceRow0, local), dot(instanceRow1, local), dot(instanceRow2, local)
  );
  return clipFromScene * vec4(scene, 1.0);
}

void main() {
  vec4 here = clipPlace(position);
  vec4 there = clipPlace(otherEnd);
  vec2 along = (there.xy / there.w - here.xy / here.w) * viewportSize;
  float size = length(along);
  vec2 across = size > 0.0 ? vec2(-along.y, along.x) / size : vec2(0.0);
  float side = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  here.xy += across * side * lineWidth / viewportSize * here.w;
  lineColor = instanceColor;
  gl_Position = here;
}
